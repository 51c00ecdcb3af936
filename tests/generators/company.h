// Cases in company: promise G7, that what lies elsewhere changes no byte of a result.
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

/// One box a polygon, around all its contours. Polygons without points have empty ones.
void add_boxes_of_polygons(std::vector<Box>& boxes, const RegionView& regions);

/// Adds polygon p of `from` to `to`, or all polygons.
void append_polygon(RegionSet& to, const RegionView& from, std::size_t p);
void append(RegionSet& to, const RegionView& from);

/// Results of which no box meets one of another, as one result: their polygons, put in order.
RegionSet put_in_order(std::span<const RegionSet> results);

/// True when the overlay is that of each set of polygons whose boxes hang together, put in order: promise G7.
/// For making failing input smaller. Cost: quadratic in the polygons.
bool is_local(const Operands& operands, Operation operation, const Options& options);

}  // namespace oblast::generators
