// Cells of points that are polygons as they come from the diagram, so that they need no noding.
//
// Rounding moves the vertices of the diagram. Where every cell of an object is still a convex polygon,
// counter-clockwise (or one with vertices on its sides), the winding number of each cell is 0 or 1 at every place. In
// the frame these add up to 1 (docs/zones.md), so the cells do not overlap and leave no gap. Cells whose boxes lie
// strictly within the frame are rows then. Only the others are noded, with the frame; to them, all whole cells together
// are one more object, the rest. Noding may not have moved its outline: then whole cells and the others still
// share their borders.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>

#include "zones/diagram.h"
#include "zones/frame_interior.h"

namespace oblast::internal::zoning {

/// An edge of a contour.
struct OutlineEdge {
  Point from, to;

  friend bool operator==(const OutlineEdge&, const OutlineEdge&) = default;
  friend bool operator<(const OutlineEdge& p, const OutlineEdge& q) {
    return p.from != q.from ? lexicographically_less(p.from, q.from) : lexicographically_less(p.to, q.to);
  }
};

struct WholeCells {
  LargeArray<Point> points;      ///< cell by cell, each from its smallest vertex, counter-clockwise
  Array<std::uint32_t> ends;     ///< by cell
  Array<std::uint32_t> objects;  ///< by cell; no object has two
  Array<OutlineEdge> outline;    ///< edges between whole cells and others, those on their left, sorted

  bool empty() const { return ends.empty(); }
};

/// Finds the whole cells, and gives their vertices to the object `rest`. Finds none if the cell of some object is not
/// convex. Objects with several vertices have no whole cells. REQUIRES: all sites are points, not samples.
WholeCells take_whole_cells(Diagram& diagram, const FrameInterior& frame, std::uint32_t rest);

}  // namespace oblast::internal::zoning
