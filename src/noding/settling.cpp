#include "noding/settling.h"

#include <oblast/domain.h>

#include <algorithm>
#include <utility>

#include "exact/expansion.h"
#include "exact/intersection_point.h"
#include "plane/box.h"
#include "plane/largest_ulp.h"

namespace oblast::internal::noding {
namespace {

/// The nearest multiple of `unit` in [low, high].
double round_to_multiple(double value, double unit, double low, double high) {
  const double rounded = std::nearbyint(value / unit) * unit;
  return std::clamp(in_domain(rounded) ? rounded + 0.0 : 0.0, low, high);
}

/// The unit in the last place of the largest coordinate of two edges.
double largest_ulp(const std::array<Point, 4>& ends) { return ulp_of(largest_coordinate(ends)); }

/// x, where (a, b) and (c, d) cross, as a multiple of the unit in the boxes of both.
Point round_further(const Point& x, const Point& a, const Point& b, const Point& c, const Point& d, double unit) {
  const Box p = Box::of(a, b), q = Box::of(c, d);
  return {round_to_multiple(x.x, unit, std::max(p.x0, q.x0), std::min(p.x1, q.x1)),
          round_to_multiple(x.y, unit, std::max(p.y0, q.y0), std::min(p.y1, q.y1))};
}

}  // namespace

Point new_vertex(const Settling& settling, const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point x = exact::intersection_point(a, b, c, d);
  if (settling.doublings < 0) return x;
  return round_further(x, a, b, c, d, std::ldexp(largest_ulp({a, b, c, d}), settling.doublings));
}

double settling_distance(const Settling& settling, const std::array<Point, 4>& ends) {
  return settling.tolerance * largest_ulp(ends);
}

double distance_from_line(const Point& p, Point a, Point b) {
  if (lexicographically_less(b, a)) std::swap(a, b);
  using exact::difference;
  const auto cross = difference(b.x, a.x) * difference(p.y, a.y) - difference(b.y, a.y) * difference(p.x, a.x);
  // Not std::hypot, whose last bit differs between C libraries. In the domain no square under- or overflows.
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::fabs(cross.estimate()) / std::sqrt(dx * dx + dy * dy);
}

}  // namespace oblast::internal::noding
