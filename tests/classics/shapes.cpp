#include "classics/shapes.h"

#include <algorithm>
#include <set>

#include "exact/orientation.h"
#include "generators/soup.h"

namespace oblast::tests {
using namespace internal;
namespace {

using exact::orientation;

bool less(const Point& p, const Point& q) { return lexicographically_less(p, q); }

/// Corners of the hull; with `straight`, points on its sides too.
std::vector<Point> hull_of(std::vector<Point> points, bool straight) {
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Point> hull;
  const auto add = [&](const Point& p, std::size_t bottom) {
    while (hull.size() > bottom) {
      const int t = orientation(hull[hull.size() - 2], hull.back(), p);
      if (t > 0 || (t == 0 && straight)) break;
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Point& p : points) add(p, 1);
  const std::size_t bottom = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], bottom);
  hull.pop_back();
  return hull;
}

bool has_area(const std::vector<Point>& ring) {
  for (std::size_t i = 2; i < ring.size(); ++i)
    if (orientation(ring[0], ring[1], ring[i]) != 0) return true;
  return false;
}

}  // namespace

RegionSet rectangle(double x0, double y0, double x1, double y1) {
  return one_contour(generators::rectangle(x0, y0, x1, y1));
}

std::vector<Point> rectangle(Plane& plane, int x0, int y0, int x1, int y1) {
  return {plane.at(x0, y0), plane.at(x1, y0), plane.at(x1, y1), plane.at(x0, y1)};
}

namespace {

/// A rectangle, and most often one or two in it.
void nest(Plane& plane, int x0, int y0, int x1, int y1, std::vector<std::vector<Point>>& contours) {
  if (x1 - x0 < 1 || y1 - y0 < 1) return;
  Random& random = plane.random();
  contours.push_back(rectangle(plane, x0, y0, x1, y1));
  if (x1 - x0 < 3 || random.one_in(4)) return;
  const int middle = random.one_in(2) ? x1 - 1 : random.between(x0 + 1, x1 - 1);
  nest(plane, x0 + 1, y0 + 1, middle, y1 - 1, contours);
  nest(plane, middle + 1, y0 + 1, x1 - 1, y1 - 1, contours);
}

}  // namespace

RegionSet nested(Plane& plane) {
  Random& random = plane.random();
  std::vector<std::vector<Point>> contours;
  nest(plane, 0, 0, plane.size(), plane.size(), contours);
  std::vector<std::vector<Point>> polygons[3];
  const int count = random.between(1, 3);
  for (std::vector<Point>& contour : contours) {
    if (random.one_in(2)) std::reverse(contour.begin(), contour.end());
    auto& polygon = polygons[random.below(count)];
    polygon.insert(polygon.begin() + random.between(0, static_cast<int>(polygon.size())), std::move(contour));
  }
  RegionSet regions;
  for (const auto& polygon : polygons)
    for (std::size_t k = 0; k < polygon.size(); ++k)
      k == 0 ? generators::add_polygon(regions, polygon[k]) : generators::add_hole(regions, polygon[k]);
  return regions;
}

std::vector<Point> convex(Plane& plane) {
  Random& random = plane.random();
  for (;;) {
    std::vector<Point> points(static_cast<std::size_t>(random.between(3, random.one_in(3) ? 30 : 8)));
    for (Point& p : points) p = plane.point();
    std::vector<Point> ring = hull_of(points, random.one_in(2));
    if (ring.size() < 3 || !has_area(ring)) continue;
    std::rotate(ring.begin(), ring.begin() + random.below(static_cast<int>(ring.size())), ring.end());
    return ring;
  }
}

/// Points in the order of the angle around one of them, or split by a line: simple where no two agree.
std::vector<Point> simple(Plane& plane, int n) {
  for (;;) {
    std::vector<Point> points(static_cast<std::size_t>(n));
    for (Point& p : points) p = plane.point();
    std::sort(points.begin(), points.end(), less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) continue;
    const Point first = points.front(), last = points.back();
    std::vector<Point> lower{first}, upper;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (orientation(first, last, points[i]) < 0 || (i > 1 && plane.random().one_in(2) && upper.empty()))
        lower.push_back(points[i]);
      else
        upper.push_back(points[i]);
    }
    std::vector<Point> kept;
    for (const Point& p : upper)
      if (orientation(first, last, p) > 0) kept.push_back(p);
    std::erase_if(lower, [&](const Point& p) { return p != first && orientation(first, last, p) >= 0; });
    lower.push_back(last);
    lower.insert(lower.end(), kept.rbegin(), kept.rend());
    if (lower.size() >= 3) return lower;
  }
}

std::vector<Point> tangle(Plane& plane, int n) {
  std::vector<Point> points(static_cast<std::size_t>(n));
  for (Point& p : points) p = plane.point();
  return points;
}

// A closed walk along the sides and one diagonal of the cells of a grid. Each lattice place has one point, so
// edges meet at their ends only, and walked twice they coincide.
std::vector<Point> vertex_complete(Plane& plane) {
  Random& random = plane.random();
  const int side = std::min(plane.size(), random.between(2, 6));
  std::vector<std::vector<Point>> lattice;
  for (int x = 0; x <= side; ++x) {
    lattice.emplace_back();
    for (int y = 0; y <= side; ++y) lattice.back().push_back(plane.at(x, y));
  }
  for (;;) {
    int x = random.between(0, side), y = random.between(0, side);
    std::vector<std::pair<int, int>> walk{{x, y}};
    const int steps = random.between(3, 40);
    constexpr int dx[] = {1, 1, 0, -1, -1, 0}, dy[] = {0, 1, 1, 0, -1, -1};
    int heading = random.below(6);
    for (int i = 0; i < steps; ++i) {
      if (!random.one_in(2)) heading = (heading + random.between(1, 5)) % 6;
      if (x + dx[heading] < 0 || x + dx[heading] > side || y + dy[heading] < 0 || y + dy[heading] > side) continue;
      x += dx[heading];
      y += dy[heading];
      walk.emplace_back(x, y);
      if (i > 8 && walk.back() == walk.front()) break;
    }
    // Home along rows and columns.
    for (; x != walk.front().first; walk.emplace_back(x, y)) x += x < walk.front().first ? 1 : -1;
    for (; y != walk.front().second; walk.emplace_back(x, y)) y += y < walk.front().second ? 1 : -1;
    walk.pop_back();
    std::vector<Point> points;
    for (const auto& [i, j] : walk) points.push_back(lattice[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    if (points.size() >= 3) return points;
  }
}

//   .-----------------.
//   |  .--.  .--.     |      bridges from the lower side up to the first corner of each hole; every corner is a
//   |  |  |  |  |     |      place of the lattice, a hole of 1 x 1 or 1 x 2 cells every second column
//   |  1--'  1--'     |
//   0--+-----+--------'
std::vector<Point> keyhole(Plane& plane) {
  Random& random = plane.random();
  const int holes = random.between(1, 3), height = random.between(3, 5);
  std::vector<Point> contour{plane.at(0, 0)};
  for (int hole = 0; hole < holes; ++hole) {
    const int x = 2 * hole + 1, top = random.between(2, height - 1);
    const Point foot = plane.at(x, 0), first = plane.at(x, 1);
    contour.insert(contour.end(),
                   {foot, first, plane.at(x, top), plane.at(x + 1, top), plane.at(x + 1, 1), first, foot});
  }
  contour.insert(contour.end(), {plane.at(2 * holes + 1, 0), plane.at(2 * holes + 1, height), plane.at(0, height)});
  return contour;
}

std::vector<Point> notched(Plane& plane) {
  for (;;) {
    std::vector<Point> ring = convex(plane);
    // A vertex put between two neighbours, well inside.
    const Point &p = ring[0], &q = ring[1], &r = ring[2];
    const Point inner{(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3};
    if (orientation(p, q, inner) <= 0) continue;
    ring.insert(ring.begin() + 1, inner);
    return ring;
  }
}

std::vector<Point> wound_twice(Plane& plane) {
  std::vector<Point> ring = convex(plane);
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) ring.push_back(ring[i]);
  return ring;
}

std::vector<Point> crossed(Plane& plane) {
  for (;;) {
    const Point a = plane.point(), b = plane.point(), c = plane.point(), d = plane.point();
    if (orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0)
      return {a, b, c, d};
  }
}

std::vector<Point> overlapping_edges(Plane& plane) {
  const double x = plane.random().between(1, 5), y = plane.random().between(1, 5);
  // Goes out along the bottom, comes back along a part of it.
  return {{0, 0}, {3 * x, 0}, {3 * x, y}, {2 * x, y}, {2 * x, 0}, {x, 0}, {x, y}, {0, y}};
}

RegionSet two_that_overlap(Plane& plane) {
  const std::vector<Point> ring = crossed(plane);
  RegionSet r = one_contour({ring[0], ring[2], ring[1]});
  generators::add_polygon(
      r, {ring[2], ring[3], {ring[3].x + (ring[1].x - ring[0].x), ring[3].y + (ring[1].y - ring[0].y)}});
  return r;
}

RegionSet hole_directed_wrongly(Plane& plane) {
  const double w = plane.random().between(3, 50);
  RegionSet r = rectangle(0, 0, w, w);
  const std::vector<Point> hole{{1, 1}, {w - 1, 1}, {1, w - 1}};
  plane.random().one_in(2) ? generators::add_hole(r, hole) : generators::add_polygon(r, hole);
  return r;
}

RegionSet vertex_on_own_edge(Plane& plane) {
  const double w = 2 * plane.random().between(2, 50);
  RegionSet r = rectangle(0, 0, w, w);
  generators::add_polygon(r, {{w / 2, w}, {w, 2 * w}, {0, 2 * w}});
  return r;
}

}  // namespace oblast::tests
