// In which of its regions does a point lie? Prepared once, asked a million times; exact on boundaries, too.
#include <oblast/oblast.h>

#include <cmath>
#include <cstdio>

int main() {
  oblast::RegionBuilder builder;
  std::vector<oblast::Point> ring;
  for (int i = 0; i < 5'000; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 5'000, r = 10 + std::sin(40 * angle);
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  builder.add_polygon(ring);
  const oblast::Locator locator(oblast::unite(builder.take()));

  std::vector<oblast::Point> points;
  for (int i = 0; i < 1'000'000; ++i) points.push_back({-12 + 0.024 * (i % 1000), -12 + 0.024 * (i / 1000)});
  points.push_back(ring[17]);
  std::vector<oblast::Location> locations(points.size());
  locator.locate(points, locations);  // on all cores
  std::size_t count[3] = {};
  for (const oblast::Location location : locations) ++count[static_cast<int>(location)];
  std::printf("outside %zu, on the boundary %zu, inside %zu\n", count[0], count[1], count[2]);
}
