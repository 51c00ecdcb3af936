// Builds contours for the hostile generators.
#include "generators/soup.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

namespace oblast::generators {
namespace {

double into_domain(double c) { return std::abs(c) < domain_smallest ? 0.0 : c; }

void append(RegionSet& soup, const Ring& ring) {
  for (const Point& p : ring) soup.points.push_back({into_domain(p.x), into_domain(p.y)});
  soup.contour_ends.push_back(static_cast<std::uint32_t>(soup.points.size()));
}

}  // namespace

void add_polygon(RegionSet& soup, const Ring& ring) {
  append(soup, ring);
  soup.polygon_ends.push_back(static_cast<std::uint32_t>(soup.contour_ends.size()));
}

void add_hole(RegionSet& soup, const Ring& ring) {
  if (soup.polygon_ends.empty()) return add_polygon(soup, ring);
  append(soup, ring);
  ++soup.polygon_ends.back();
}

void add_either_way(RegionSet& soup, const Ring& ring, Random& random) {
  if (random.one_in(3)) return add_hole(soup, ring);
  add_polygon(soup, ring);
}

Ring rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

double nudge(double coordinate, int steps, Random& random) {
  if (coordinate == 0) return coordinate;
  for (int moves = random.between(-steps, steps); moves != 0; moves -= moves > 0 ? 1 : -1) {
    coordinate = std::nextafter(coordinate, moves > 0 ? HUGE_VAL : -HUGE_VAL);
  }
  return coordinate;
}

Ring nudge(Ring ring, int steps, Random& random) {
  for (Point& p : ring) p = {nudge(p.x, steps, random), nudge(p.y, steps, random)};
  return ring;
}

Point along(const Point& a, const Point& b, Random& random) {
  const double t = random.one_in(4) ? 0.5 : random.unit();
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace oblast::generators
