// Cases with others, for promise G7: polygons elsewhere change no byte of a result.
#pragma once

#include <oblast/options.h>

#include <cmath>
#include <span>
#include <vector>

#include "generators/hostile.h"

namespace oblast::generators {

/// A closed axis-parallel rectangle; without points it meets nothing.
struct Box {
  double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;

  void add(const Point& p);
  void add(const Box& other);
  bool empty() const { return x1 < x0; }
  bool contains(const Point& p) const { return x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1; }
  bool meets(const Box& other) const { return x0 <= other.x1 && other.x0 <= x1 && y0 <= other.y1 && other.y0 <= y1; }
};

Box box_of(std::span<const Point> points);
Box box_of(const Operands& operands);

/// Adds one box per polygon, around all its contours. Polygons without points have empty boxes.
void add_boxes_of_polygons(std::vector<Box>& boxes, const RegionView& regions);

/// Adds polygon p of `from` to `to`, or all polygons.
void append_polygon(RegionSet& to, const RegionView& from, std::size_t p);
void append(RegionSet& to, const RegionView& from);

/// Joins results whose boxes do not meet: their polygons, sorted.
RegionSet put_in_order(std::span<const RegionSet> results);

/// True if the overlay equals the sorted overlays of all sets of polygons whose boxes are connected (promise G7). Used
/// to make failing input smaller. Cost: quadratic in the polygons.
bool is_local(const Operands& operands, Operation operation, const Options& options);

}  // namespace oblast::generators
