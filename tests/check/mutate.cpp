#include "check/mutate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace oblast::testing {
namespace {

using generators::Random;
using Contour = std::vector<Point>;
using Polygon = std::vector<Contour>;
using Polygons = std::vector<Polygon>;

Polygons polygons_of(const RegionSet& regions) {
  Polygons polygons;
  for (const PolygonView polygon : regions.view().polygons()) {
    polygons.emplace_back();
    for (const auto contour : polygon.contours()) polygons.back().emplace_back(contour.begin(), contour.end());
  }
  return polygons;
}

RegionSet regions_of(const Polygons& polygons) {
  RegionSet regions;
  for (const Polygon& polygon : polygons) {
    for (const Contour& contour : polygon) {
      regions.points.insert(regions.points.end(), contour.begin(), contour.end());
      regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
    }
    regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
  }
  return regions;
}

auto& any_of(auto& items, Random& random) {
  return items[static_cast<std::size_t>(random.below(static_cast<int>(std::size(items))))];
}
Contour& any_contour(Polygons& polygons, Random& random) { return any_of(any_of(polygons, random), random); }

/// A polygon with the most contours.
Polygon& richest(Polygons& polygons) {
  return *std::max_element(polygons.begin(), polygons.end(),
                           [](const Polygon& p, const Polygon& q) { return p.size() < q.size(); });
}

template <void (*change)(Polygons&, Random&)>
RegionSet changed(const RegionSet& regions, Random& random) {
  Polygons polygons = polygons_of(regions);
  change(polygons, random);
  return regions_of(polygons);
}

void move_vertex_by_an_ulp(Polygons& polygons, Random& random) {
  Point& p = any_of(any_contour(polygons, random), random);
  p.x = std::nextafter(p.x, random.one_in(2) ? 1e300 : -1e300);
}
void move_vertex_far(Polygons& polygons, Random& random) {
  Point& p = any_of(any_contour(polygons, random), random);
  p = {p.x * random.in(0.5, 1.5), p.y * random.in(0.5, 1.5)};
}
void move_vertex_to_another(Polygons& polygons, Random& random) {
  const Point other = any_of(any_contour(polygons, random), random);
  any_of(any_contour(polygons, random), random) = other;
}
void move_vertex_into_an_edge(Polygons& polygons, Random& random) {
  const Contour& other = any_contour(polygons, random);
  const Point p = {(other[0].x + other[1].x) / 2, (other[0].y + other[1].y) / 2};
  any_of(any_contour(polygons, random), random) = p;
}
void drop_vertex(Polygons& polygons, Random& random) {
  Contour& contour = any_contour(polygons, random);
  contour.erase(contour.begin() + random.below(static_cast<int>(contour.size())));
}
void repeat_vertex(Polygons& polygons, Random& random) {
  Contour& contour = any_contour(polygons, random);
  const auto at = contour.begin() + random.below(static_cast<int>(contour.size()));
  contour.insert(at, Point(*at));
}
void repeat_first_vertex(Polygons& polygons, Random& random) {
  Contour& contour = any_contour(polygons, random);
  contour.push_back(Point(contour[0]));
}
void leave_two_vertices(Polygons& polygons, Random& random) { any_contour(polygons, random).resize(2); }
void rotate_start(Polygons& polygons, Random& random) {
  Contour& contour = any_contour(polygons, random);
  std::rotate(contour.begin(), contour.begin() + random.below(static_cast<int>(contour.size())), contour.end());
}
void reverse_contour(Polygons& polygons, Random& random) {
  Contour& contour = any_contour(polygons, random);
  std::reverse(contour.begin() + 1, contour.end());
}
void reverse_polygon(Polygons& polygons, Random& random) {
  for (Contour& contour : any_of(polygons, random)) std::reverse(contour.begin() + 1, contour.end());
}
void drop_hole(Polygons& polygons, Random&) {
  if (Polygon& polygon = richest(polygons); polygon.size() > 1) polygon.pop_back();
}
void drop_outer(Polygons& polygons, Random&) {
  if (Polygon& polygon = richest(polygons); polygon.size() > 1) polygon.erase(polygon.begin());
}
void swap_outer_and_hole(Polygons& polygons, Random&) {
  if (Polygon& polygon = richest(polygons); polygon.size() > 1) std::swap(polygon[0], polygon[1]);
}
void swap_holes(Polygons& polygons, Random&) {
  if (Polygon& polygon = richest(polygons); polygon.size() > 2) std::swap(polygon[1], polygon.back());
}
void move_hole_to_another_polygon(Polygons& polygons, Random& random) {
  Polygon& polygon = richest(polygons);
  Polygon& other = any_of(polygons, random);
  if (polygon.size() < 2 || &other == &polygon) return;
  other.push_back(std::move(polygon.back()));
  polygon.pop_back();
}
void make_hole_a_polygon(Polygons& polygons, Random&) {
  Polygon& polygon = richest(polygons);
  if (polygon.size() < 2) return;
  Contour hole = std::move(polygon.back());
  polygon.pop_back();
  std::reverse(hole.begin() + 1, hole.end());
  polygons.push_back({std::move(hole)});
}
void swap_polygons(Polygons& polygons, Random& random) {
  std::swap(any_of(polygons, random), any_of(polygons, random));
}
void join_polygons(Polygons& polygons, Random&) {
  if (polygons.size() < 2) return;
  polygons[0].insert(polygons[0].end(), polygons[1].begin(), polygons[1].end());
  polygons.erase(polygons.begin() + 1);
}
void repeat_contour(Polygons& polygons, Random& random) {
  Polygon& polygon = any_of(polygons, random);
  polygon.push_back(Contour(any_of(polygon, random)));
}
void repeat_polygon(Polygons& polygons, Random& random) { polygons.push_back(Polygon(any_of(polygons, random))); }
void fill_hole(Polygons& polygons, Random&) {
  const Polygon& polygon = richest(polygons);
  if (polygon.size() < 2) return;
  Contour filled = polygon.back();
  std::reverse(filled.begin() + 1, filled.end());
  polygons.push_back({std::move(filled)});
}
/// A triangle from a corner of a contour along its two edges: they overlap, or it shares a vertex only.
void add_triangle_at_a_corner(Polygons& polygons, Random& random) {
  const Contour& contour = any_contour(polygons, random);
  const Point &a = contour[0], &b = contour[1], &c = contour.back();
  if (random.one_in(2))
    polygons.push_back({{a, {(a.x + b.x) / 2, (a.y + b.y) / 2}, {(a.x + c.x) / 2, (a.y + c.y) / 2}}});
  else
    polygons.push_back({{a, {2 * a.x - b.x, 2 * a.y - b.y}, {2 * a.x - c.x, 2 * a.y - c.y}}});
}
/// A small hole or a small polygon somewhere, most often inside another one.
void add_triangle_anywhere(Polygons& polygons, Random& random) {
  const Point p = any_of(any_contour(polygons, random), random), q = any_of(any_contour(polygons, random), random);
  const double t = random.unit(), size = (std::fabs(q.x - p.x) + std::fabs(q.y - p.y)) / 1000;
  const Point at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  Contour triangle{at, {at.x + size, at.y}, {at.x + size, at.y + size}};
  if (random.one_in(2)) {
    polygons.push_back({std::move(triangle)});
  } else {
    std::reverse(triangle.begin() + 1, triangle.end());
    any_of(polygons, random).push_back(std::move(triangle));
  }
}
void negate_zero(Polygons& polygons, Random& random) {
  Point& p = any_of(any_contour(polygons, random), random);
  (random.one_in(2) ? p.x : p.y) = -0.0;
}
void spoil_coordinate(Polygons& polygons, Random& random) {
  constexpr double spoiled[] = {NAN, INFINITY, 1e200, 1e-200};
  any_of(any_contour(polygons, random), random).y = any_of(spoiled, random);
}

RegionSet spoil_offsets(const RegionSet& regions, Random& random) {
  RegionSet result = regions;
  auto& ends = random.one_in(2) ? result.contour_ends : result.polygon_ends;
  auto& end = any_of(ends, random);
  end = random.one_in(2) ? end + 1 : random.one_in(2) ? end - 1 : 0;
  return result;
}

constexpr Mutation all[] = {
    {"a vertex by an ulp", changed<move_vertex_by_an_ulp>},
    {"a vertex far", changed<move_vertex_far>},
    {"a vertex to another", changed<move_vertex_to_another>},
    {"a vertex into an edge", changed<move_vertex_into_an_edge>},
    {"a vertex less", changed<drop_vertex>},
    {"a repeated vertex", changed<repeat_vertex>},
    {"a repeated first vertex", changed<repeat_first_vertex>},
    {"two vertices", changed<leave_two_vertices>},
    {"another start", changed<rotate_start>},
    {"a reversed contour", changed<reverse_contour>},
    {"a reversed polygon", changed<reverse_polygon>},
    {"a hole less", changed<drop_hole>},
    {"an outer contour less", changed<drop_outer>},
    {"a hole before its outer contour", changed<swap_outer_and_hole>},
    {"swapped holes", changed<swap_holes>},
    {"a hole in another polygon", changed<move_hole_to_another_polygon>},
    {"a hole as a polygon", changed<make_hole_a_polygon>},
    {"swapped polygons", changed<swap_polygons>},
    {"joined polygons", changed<join_polygons>},
    {"a repeated contour", changed<repeat_contour>},
    {"a repeated polygon", changed<repeat_polygon>},
    {"a filled hole", changed<fill_hole>},
    {"a triangle at a corner", changed<add_triangle_at_a_corner>},
    {"a triangle anywhere", changed<add_triangle_anywhere>},
    {"a negative zero", changed<negate_zero>},
    {"a spoiled coordinate", changed<spoil_coordinate>},
    {"spoiled offsets", spoil_offsets},
};

}  // namespace

std::span<const Mutation> mutations() { return all; }

}  // namespace oblast::testing
