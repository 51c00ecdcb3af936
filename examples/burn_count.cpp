// How much land burned at least once, twice, three times: the fill rule `at_least` over all contours in one pass.
#include <oblast/oblast.h>

#include <cstdio>

int main() {
  oblast::RegionBuilder fires;  // detections of four satellite passes
  const double passes[][4] = {{0, 0, 6, 4}, {2, 1, 8, 5}, {4, 2, 10, 6}, {5, 0, 7, 7}};
  for (const auto& [x0, y0, x1, y1] : passes)
    fires.add_polygon(std::array<oblast::Point, 4>{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}});
  const oblast::RegionSet detections = fires.take();
  for (int times = 1; times <= 4; ++times) {
    oblast::Options options;
    options.fill_a = oblast::FillRule::at_least(times);
    std::printf("burned %d times or more: %g\n", times, oblast::area(oblast::unite(detections, options)));
  }
}
