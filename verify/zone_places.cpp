#include "verify/zone_places.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "verify/box_tree.h"

namespace oblast::verify {
namespace {

constexpr std::uint64_t places_by_edge = 6;

Point at(const Stroke& e, double t) { return {e.a.x + (e.b.x - e.a.x) * t, e.a.y + (e.b.y - e.a.y) * t}; }

/// Up to 4 units in the last place away, but not out of the domain, where predicates are exact.
double step(double x, std::uint64_t random) {
  const double unit = std::max(std::nextafter(std::abs(x), HUGE_VAL) - std::abs(x), domain_smallest);
  const double moved = x + (static_cast<double>(random % 9) - 4) * unit;
  return in_domain(moved) ? moved : x;
}

std::vector<Stroke> edges_of(const RegionView& regions) {
  std::vector<Stroke> edges;
  for (const std::span<const Point> ring : regions.contours())
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return edges;
}

}  // namespace

std::vector<Point> zone_places(const JudgedZones& zones, std::uint64_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Point> places;
  Box box;
  for (const Point& p : zones.frame.points) box.add({p, p});
  const Point &low = box.low, &high = box.high;
  for (std::uint64_t k = 0; k < count && !box.empty(); ++k) {
    const double x = low.x + (high.x - low.x) * unit();
    places.push_back({x, low.y + (high.y - low.y) * unit()});
  }
  const std::vector<Stroke> borders = edges_of(zones.rows.regions);
  // All edges in turn, again and again, if there are few; else some of them.
  const std::uint64_t edges = borders.empty() ? 0 : count / places_by_edge + 1;
  const bool is_few = borders.size() <= edges;
  for (std::uint64_t k = 0; k < edges; ++k) {
    const Stroke& e = borders[(is_few ? k : random()) % borders.size()];
    const Point on[] = {e.a, at(e, 0.5), at(e, unit())};
    for (const Point& p : on) {
      places.push_back(p);
      const double x = step(p.x, random());
      places.push_back({x, step(p.y, random())});
    }
  }
  return places;
}

}  // namespace oblast::verify
