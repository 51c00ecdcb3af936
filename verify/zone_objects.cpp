#include "verify/zone_objects.h"

#include <algorithm>

#include "verify/predicates.h"

namespace oblast::verify {
namespace {

void sort_out(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

bool less(const Stroke& s, const Stroke& t) {
  return s.a != t.a ? lexicographically_less(s.a, t.a) : lexicographically_less(s.b, t.b);
}

bool holds(const Stroke& s, const Point& p) {
  return p != s.a && p != s.b && s.box().meets(Box(p, p)) && side_of_line(s.a, s.b, p) == 0;
}

}  // namespace

std::vector<Stroke> boundary_of(const RegionView& polygon) {
  std::vector<Stroke> edges;
  std::vector<Box> boxes;
  for (const std::span<const Point> ring : polygon.contours())
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point p = ring[i], q = ring[(i + 1) % ring.size()];
      if (p == q) continue;
      edges.push_back(lexicographically_less(p, q) ? Stroke{p, q} : Stroke{q, p});
      boxes.push_back(edges.back().box());
    }
  const BoxTree tree(boxes);
  std::vector<Stroke> pieces;
  for (const Stroke& e : edges) {
    std::vector<Point> on{e.a, e.b};
    tree.meeting(e.box(), [&](std::uint32_t k) {
      for (const Point& p : {edges[k].a, edges[k].b})
        if (holds(e, p)) on.push_back(p);
    });
    std::sort(on.begin(), on.end(), lexicographically_less);
    on.erase(std::unique(on.begin(), on.end()), on.end());
    for (std::size_t i = 0; i + 1 < on.size(); ++i) pieces.push_back({on[i], on[i + 1]});
  }
  std::sort(pieces.begin(), pieces.end(), less);
  std::vector<Stroke> odd;
  for (const Stroke& s : pieces) {
    if (!odd.empty() && odd.back() == s)
      odd.pop_back();
    else
      odd.push_back(s);
  }
  return odd;
}

void NumberedAreas::add(std::vector<Stroke> edges, std::uint32_t number) {
  if (edges.empty()) return;
  areas.emplace_back(std::move(edges));
  numbers.push_back(number);
}

void NumberedAreas::build() {
  std::vector<Box> boxes;
  for (const Area& area : areas) boxes.push_back(area.box());
  tree = BoxTree(std::move(boxes));
}

std::vector<std::uint32_t> NumberedAreas::closed_at(const Point& p) const {
  std::vector<std::uint32_t> found;
  tree.meeting(Box(p, p), [&](std::uint32_t k) {
    if (areas[k].where(p) != Area::Where::outside) found.push_back(numbers[k]);
  });
  sort_out(found);
  return found;
}

NumberedAreas::Sides NumberedAreas::beside(const Location& p, bool on_horizontal) const {
  Sides found;
  tree.meeting(p.box(), [&](std::uint32_t k) {
    const Area::Sides sides = areas[k].beside(p, on_horizontal);
    if (sides.first) found.first.push_back(numbers[k]);
    if (sides.second) found.second.push_back(numbers[k]);
  });
  sort_out(found.first);
  sort_out(found.second);
  return found;
}

ZoneObjects::ZoneObjects(const ShapeFeatures& objects) {
  const RegionView& polygons = objects.shapes.regions;
  const LineView& lines = objects.shapes.lines;
  const bool numbered = !objects.region_rows.empty() || !objects.line_rows.empty() || !objects.point_rows.empty();
  const auto row = [&](std::span<const std::uint32_t> rows, std::size_t shape, std::size_t before) {
    return numbered ? rows[shape] : static_cast<std::uint32_t>(before + shape);
  };
  for (std::size_t p = 0; p < polygons.polygon_count(); ++p) {
    const std::uint32_t object = row(objects.region_rows, p, 0);
    std::vector<Stroke> boundary = boundary_of(polygons.polygon(p));
    for (const Stroke& s : boundary) edges.push_back({s, object, true});
    regions.add(std::move(boundary), object);
  }
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const std::span<const Point> line = lines[l];
    const std::uint32_t object = row(objects.line_rows, l, polygons.polygon_count());
    const std::size_t before = edges.size();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      if (line[i] != line[i + 1]) edges.push_back({{line[i], line[i + 1]}, object, false});
    if (edges.size() == before && !line.empty()) edges.push_back({{line[0], line[0]}, object, false});
  }
  for (std::size_t i = 0; i < objects.shapes.points.size(); ++i) {
    const Point p = objects.shapes.points[i];
    edges.push_back({{p, p}, row(objects.point_rows, i, polygons.polygon_count() + lines.size()), false});
  }
  regions.build();
  std::vector<Box> boxes;
  for (const Edge& e : edges) boxes.push_back(e.box());
  tree = BoxTree(std::move(boxes));
}

}  // namespace oblast::verify
