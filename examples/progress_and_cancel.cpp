// A long call that reports its progress and is cancelled halfway.
#include <oblast/oblast.h>

#include <cmath>
#include <cstdio>

int main() {
  oblast::RegionBuilder builder;  // 40,000 squares that overlap, each turned a little
  for (int i = 0; i < 40'000; ++i) {
    const double x = i % 200, y = i / 200, turn = 0.1 * i;
    const double c = 0.8 * std::cos(turn), s = 0.8 * std::sin(turn);
    builder.add_polygon(std::array<oblast::Point, 4>{{{x + c, y + s}, {x - s, y + c}, {x - c, y - s}, {x + s, y - c}}});
  }
  const oblast::RegionSet squares = builder.take();

  oblast::Options options;
  options.progress = [](oblast::Stage, double fraction) {  // from one thread at a time
    std::fprintf(stderr, "\r%3.0f %%", 100 * fraction);
    return true;
  };
  const oblast::RegionSet united = oblast::unite(squares, options);
  std::printf("\n%zu polygons, %zu vertices\n", united.polygon_ends.size(), united.points.size());

  options.progress = [](oblast::Stage, double fraction) { return fraction < 0.5; };
  try {
    oblast::unite(squares, options);
  } catch (const oblast::Error& error) {
    std::printf("stopped: %s\n", error.code() == oblast::ErrorCode::cancelled ? "cancelled" : error.what());
  }
}
