#include "classics/cases.h"

#include <oblast/overlay.h>

#include <algorithm>
#include <cmath>

#include "classics/shapes.h"
#include "exact/orientation.h"
#include "generators/soup.h"
#include "verify/slabs.h"

namespace oblast::tests {
using namespace internal;
namespace {

Operation draw_operation(Random& random) {
  constexpr Operation three[] = {Operation::intersection, Operation::unite, Operation::difference};
  return three[random.below(3)];
}

RegionSet reversed(RegionSet r) {
  std::uint32_t begin = 0;
  for (const std::uint32_t end : r.contour_ends) {
    std::reverse(r.points.begin() + begin, r.points.begin() + end);
    begin = end;
  }
  return r;
}

/// A result of `overlay` is a regular polygon with oriented contours.
RegionSet regular(Plane& plane) {
  Random& random = plane.random();
  RegionSet soup;
  // In half of the cases nothing crosses. Then on a grid all vertices are integers, also with holes and touching
  // vertices.
  const bool complete = random.one_in(2);
  const int rings = complete ? 1 : random.between(1, 3);
  for (int i = 0; i < rings; ++i)
    generators::add_polygon(soup, complete ? vertex_complete(plane) : tangle(plane, random.between(3, 8)));
  if (random.one_in(3)) soup = one_contour(keyhole(plane));  // becomes a ring with holes
  Options options;
  options.fill_a = FillRule::even_odd();
  const RegionSet r = unite(soup, options);
  return r.empty() ? one_contour(simple(plane, 4)) : r;
}

ClassicCase convex_pair(Plane& plane) {
  Random& random = plane.random();
  ClassicCase c{one_contour(convex(plane)), one_contour(convex(plane)), draw_operation(random)};
  if (random.one_in(12)) c.b = c.a;
  if (random.one_in(2)) c.a = reversed(c.a);
  if (random.one_in(2)) c.b = reversed(c.b);
  return c;
}

}  // namespace

Plane::Plane(Random& random, Spread spread, int size) : random_(random), spread_(spread), size_(size) {
  if (spread == Spread::grid) return;
  scale_ = std::ldexp(random.in(0.5, 1), random.between(-30, 30));
  x0_ = random.one_in(3) ? 0 : scale_ * random.in(-100, 100);
  y0_ = random.one_in(3) ? 0 : scale_ * random.in(-100, 100);
  if (spread == Spread::nearly) x0_ *= 1e3;
}

Point Plane::at(int x, int y) {
  switch (spread_) {
    case Spread::grid:
      return {static_cast<double>(x), static_cast<double>(y)};
    case Spread::reals:
      return {x0_ + scale_ * (x + random_.in(-0.2, 0.2)), y0_ + scale_ * (y + random_.in(-0.2, 0.2))};
    default:
      break;
  }
  Point p{x0_ + scale_ * x, y0_ + scale_ * y};
  if (p.x != 0 && random_.one_in(3)) p.x = std::nextafter(p.x, random_.one_in(2) ? 1e300 : -1e300);
  if (p.y != 0 && random_.one_in(3)) p.y = std::nextafter(p.y, random_.one_in(2) ? 1e300 : -1e300);
  return p;
}

Point Plane::point() { return at(random_.between(0, size_), random_.between(0, size_)); }

Spread draw_spread(Random& random) {
  const int roll = random.below(10);
  return roll < 6 ? Spread::grid : roll < 9 ? Spread::reals : Spread::nearly;
}

RegionSet one_contour(std::vector<Point> points) {
  RegionSet r;
  r.points = std::move(points);
  r.contour_ends = {static_cast<std::uint32_t>(r.points.size())};
  r.polygon_ends = {1};
  return r;
}

namespace {

ClassicCase draw(ClassicMethod method, Plane& plane) {
  Random& random = plane.random();
  switch (method) {
    case ClassicMethod::orourke:
      return convex_pair(plane);
    case ClassicMethod::sutherland_hodgman: {
      ClassicCase c{{}, one_contour(convex(plane)), Operation::intersection};
      switch (random.below(3)) {
        case 0:
          c.a = one_contour(simple(plane, random.between(3, 12)));
          break;
        case 1:
          c.a = regular(plane);
          break;
        default:
          for (int i = random.between(1, 3); i > 0; --i) generators::add_hole(c.a, tangle(plane, random.between(3, 9)));
      }
      if (random.one_in(2)) c.a = reversed(c.a);
      if (random.one_in(2)) c.b = reversed(c.b);
      return c;
    }
    case ClassicMethod::weiler_atherton: {
      ClassicCase c{regular(plane), regular(plane), draw_operation(random)};
      if (random.one_in(10)) c.b = c.a;
      if (random.one_in(3)) c.a = reversed(c.a);
      if (random.one_in(3)) c.b = reversed(c.b);
      return c;
    }
    case ClassicMethod::margalit_knott:
      break;
  }
  const auto one = [&] { return one_contour(random.one_in(4) ? keyhole(plane) : vertex_complete(plane)); };
  ClassicCase c{one(), one(), draw_operation(random)};
  if (random.one_in(10)) c.b = c.a;
  if (random.one_in(3)) c.a = reversed(c.a);
  if (random.one_in(3)) c.b = reversed(c.b);
  return c;
}

}  // namespace

ClassicCase inside(ClassicMethod method, Random& random) {
  const Spread spread = draw_spread(random);
  Plane plane(random, spread, random.between(3, random.one_in(4) ? 40 : 9));
  ClassicCase c = draw(method, plane);
  c.spread = spread;
  return c;
}

Options engine_options(ClassicMethod method, const ClassicCase& c) {
  Options options;
  if (method != ClassicMethod::weiler_atherton) return options;
  // Exactly: the rounded area of a sliver can have the other sign.
  const auto rule = [](const RegionSet& operand) {
    return verify::exact_signed_area(operand) >= 0 ? FillRule::positive() : FillRule::negative();
  };
  options.fill_a = rule(c.a);
  options.fill_b = rule(c.b);
  return options;
}

RegionSet by_pipeline(const RegionView& a, const RegionView& b, Operation operation, Options options) {
  Statistics statistics;
  options.statistics = &statistics;
  return overlay(a, b, operation, options);
}

RegionSet expected(ClassicMethod method, const ClassicCase& c) {
  return by_pipeline(c.a, c.b, c.operation, engine_options(method, c));
}

namespace {

/// A small convex quadrilateral about the middle of two random points, so that much of what surrounds it is far.
std::vector<Point> small_window(Plane& plane) {
  for (;;) {
    const Point p = plane.point(), q = plane.point();
    const Point m{(p.x + q.x) / 2, (p.y + q.y) / 2};
    const double w = (q.x - p.x) / 9, h = (q.y - p.y) / 9;
    if (w != 0 && h != 0)
      return {m, {m.x + w, m.y + h * 0.1}, {m.x + w * 0.7, m.y + h}, {m.x - w * 0.2, m.y + h * 0.8}};
  }
}

/// The same contours, all of one polygon.
RegionSet one_polygon(RegionSet r) {
  r.polygon_ends = {static_cast<std::uint32_t>(r.contour_ends.size())};
  return r;
}

RegionSet any_polygons(Plane& plane) {
  Random& random = plane.random();
  RegionSet r;
  for (int i = random.between(1, 4); i > 0; --i)
    generators::add_polygon(
        r, random.one_in(2) ? simple(plane, random.between(3, 80)) : tangle(plane, random.between(3, 6)));
  return random.one_in(2) ? one_polygon(std::move(r)) : r;
}

/// Some vertices are given twice, one after the other.
RegionSet with_repeated_vertices(const RegionSet& regions, Random& random) {
  RegionSet r;
  r.polygon_ends = regions.polygon_ends;
  for (std::uint32_t c = 0, i = 0; c < regions.contour_ends.size(); ++c) {
    for (; i < regions.contour_ends[c]; ++i)
      r.points.insert(r.points.end(), random.one_in(6) ? 2 : 1, regions.points[i]);
    r.contour_ends.push_back(static_cast<std::uint32_t>(r.points.size()));
  }
  return r;
}

ClassicCase window_case_of_distinct_neighbours(Random& random) {
  if (random.one_in(3)) return inside(ClassicMethod::orourke, random);
  const Spread spread = draw_spread(random);
  Plane plane(random, spread, random.between(3, random.one_in(2) ? 60 : 9));
  ClassicCase c{{}, one_contour(convex(plane)), Operation::intersection, spread};
  switch (random.below(5)) {
    case 0:
      c.a = any_polygons(plane);
      break;
    case 1:
      c.a = regular(plane);
      break;
    case 2:
      c.a = nested(plane);
      if (random.one_in(2)) c.b = one_contour(rectangle(plane, -1, -1, plane.size() + 1, plane.size() + 1));
      break;
    case 3:
      c.a = one_contour(simple(plane, random.between(10, 200)));
      break;
    default:
      c.a = one_contour(simple(plane, random.between(10, 200)));
      if (random.one_in(2)) generators::add_polygon(c.a, tangle(plane, 5));
      c.b = one_contour(small_window(plane));
  }
  if (random.one_in(2)) c.b = reversed(c.b);
  if (random.one_in(2)) std::swap(c.a, c.b);
  return c;
}

}  // namespace

ClassicCase window_case(Random& random) {
  ClassicCase c = window_case_of_distinct_neighbours(random);
  if (random.one_in(4)) {
    c.a = with_repeated_vertices(c.a, random);
    if (random.one_in(2)) c.b = with_repeated_vertices(c.b, random);
  }
  return c;
}

OutsideCase outside(ClassicMethod method, Random& random) {
  const bool in_b = random.one_in(2);
  OutsideCase o{inside(method, random), "", OutsideCase::Names::vertex};
  ClassicCase& c = o.operands;
  Plane plane(random, random.one_in(2) ? Spread::grid : Spread::reals, 12);
  const auto put = [&](RegionSet r, const char* why) {
    (in_b || method == ClassicMethod::sutherland_hodgman ? c.b : c.a) = std::move(r);
    o.why = why;
  };
  RegionSet two = one_contour(convex(plane));
  generators::add_polygon(two, convex(plane));
  switch (method) {
    case ClassicMethod::orourke:
    case ClassicMethod::sutherland_hodgman:
      switch (random.below(4)) {
        case 0:
          put(one_contour(notched(plane)), "a contour that is not convex");
          break;
        case 1:
          put(one_contour(wound_twice(plane)), "a convex spiral that winds twice");
          break;
        case 2:
          put(random.one_in(2) ? two : one_polygon(two), "two contours");
          o.names = OutsideCase::Names::contour;
          break;
        default:
          if (method == ClassicMethod::orourke) {
            c.operation = Operation::symmetric_difference;
            o.why = "an operation it has not";
            o.names = OutsideCase::Names::nothing;
          } else {
            c.a = two_that_overlap(plane);
            o.why = "several polygons that overlap";
          }
      }
      break;
    case ClassicMethod::weiler_atherton:
      switch (random.below(5)) {
        case 0:
          put(one_contour(crossed(plane)), "a contour that crosses itself");
          break;
        case 1:
          put(hole_directed_wrongly(plane), "a hole directed as its outer contour");
          break;
        case 2:
          put(two_that_overlap(plane), "contours that cross");
          break;
        case 3:
          c.operation = Operation::symmetric_difference;
          o.why = "an operation it has not";
          o.names = OutsideCase::Names::nothing;
          break;
        default:
          put(vertex_on_own_edge(plane), "a vertex inside an edge of another contour");
      }
      break;
    case ClassicMethod::margalit_knott:
      switch (random.below(4)) {
        case 0:
          put(one_contour(crossed(plane)), "edges that cross");
          break;
        case 1:
          put(random.one_in(2) ? two : one_polygon(two), "two contours");
          o.names = OutsideCase::Names::contour;
          break;
        case 2:
          c.operation = Operation::symmetric_difference;
          o.why = "an operation it has not";
          o.names = OutsideCase::Names::nothing;
          break;
        default:
          put(one_contour(overlapping_edges(plane)), "edges that overlap in part");
      }
  }
  return o;
}

}  // namespace oblast::tests
