// Cases with others: boxes, and joined results of parts.
#include "generators/company.h"

#include <oblast/overlay.h>

#include <algorithm>
#include <numeric>

namespace oblast::generators {
namespace {

struct Part {
  const RegionSet* regions;
  std::size_t polygon;

  std::span<const Point> outer() const {
    const RegionView view = *regions;
    return view.contour(view.polygon_begin(polygon));
  }
};

// The parts of operands whose boxes are connected: a number for each polygon, those of A first.
std::vector<std::size_t> parts_of(const Operands& operands) {
  std::vector<Box> boxes;
  add_boxes_of_polygons(boxes, operands.a);
  add_boxes_of_polygons(boxes, operands.b);
  std::vector<std::size_t> part(boxes.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (part[i] != i) i = part[i] = part[part[i]];
    return i;
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (boxes[i].meets(boxes[j])) part[root(i)] = root(j);
    }
  }
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = root(i);
  return part;
}

}  // namespace

void Box::add(const Point& p) {
  x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
  y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
}

void Box::add(const Box& other) {
  x0 = std::min(x0, other.x0), x1 = std::max(x1, other.x1);
  y0 = std::min(y0, other.y0), y1 = std::max(y1, other.y1);
}

Box box_of(std::span<const Point> points) {
  Box box;
  for (const Point& p : points) box.add(p);
  return box;
}

Box box_of(const Operands& operands) {
  Box box = box_of(operands.a.points);
  box.add(box_of(operands.b.points));
  return box;
}

void add_boxes_of_polygons(std::vector<Box>& boxes, const RegionView& regions) {
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    Box box;
    for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) box.add(box_of(regions.contour(c)));
    boxes.push_back(box);
  }
}

void append_polygon(RegionSet& to, const RegionView& from, std::size_t p) {
  for (std::size_t c = from.polygon_begin(p); c < from.polygon_end(p); ++c) {
    const auto contour = from.contour(c);
    to.points.insert(to.points.end(), contour.begin(), contour.end());
    to.contour_ends.push_back(static_cast<std::uint32_t>(to.points.size()));
  }
  to.polygon_ends.push_back(static_cast<std::uint32_t>(to.contour_ends.size()));
}

void append(RegionSet& to, const RegionView& from) {
  for (std::size_t p = 0; p < from.polygon_count(); ++p) append_polygon(to, from, p);
}

RegionSet put_in_order(std::span<const RegionSet> results) {
  std::vector<Part> parts;
  for (const RegionSet& result : results) {
    for (std::size_t p = 0; p < result.polygon_ends.size(); ++p) parts.push_back({&result, p});
  }
  std::sort(parts.begin(), parts.end(), [](const Part& p, const Part& q) {
    const auto a = p.outer(), b = q.outer();
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lexicographically_less);
  });
  RegionSet all;
  for (const Part& part : parts) append_polygon(all, *part.regions, part.polygon);
  return all;
}

bool is_local(const Operands& operands, Operation operation, const Options& options) {
  const std::vector<std::size_t> part = parts_of(operands);
  const std::size_t in_a = operands.a.view().polygon_count();
  std::vector<Operands> parts(part.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    Operands& mine = parts[part[i]];
    if (i < in_a) append_polygon(mine.a, operands.a, i);
    if (i >= in_a) append_polygon(mine.b, operands.b, i - in_a);
  }
  std::vector<RegionSet> results;
  for (const Operands& o : parts) {
    if (!o.a.polygon_ends.empty() || !o.b.polygon_ends.empty())
      results.push_back(overlay(o.a, o.b, operation, options));
  }
  return overlay(operands.a, operands.b, operation, options) == put_in_order(results);
}

}  // namespace oblast::generators
