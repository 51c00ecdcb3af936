// The outline around a corner: from one normal to another, counter-clockwise.
#pragma once

#include <oblast/point.h>

#include "base/call_memory.h"
#include "buffer/zone_shape.h"

namespace oblast::internal::buffering {

/// The place at a vector from a point, within the domain: what is too near to an axis for it goes onto the axis.
Point moved(const Point& from, const Point& by, double factor);

/// A corner with the unit normals of its two edges. From `from` to `to` is at most half a turn.
struct CornerNormals {
  Point at, from, to;
  double distance;
};

// Each appends the outline from the side of one edge to that of the next: it begins and ends at the ends of the two
// normals, or, if it goes on along the sides, where it leaves them.

void append_join(const ZoneShape& shape, const CornerNormals& corner, Array<Point>& outline);
/// REQUIRES: the cap is not flat.
void append_cap(const ZoneShape& shape, const CornerNormals& corner, Array<Point>& outline);

/// The zone of a single point, counter-clockwise; nothing if the cap is flat.
void append_disc(const ZoneShape& shape, const Point& at, Array<Point>& outline);

}  // namespace oblast::internal::buffering
