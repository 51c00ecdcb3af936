// The outline of a walk: the sum of its pieces, as contours with winding number 1 on each piece.
//
//        A                B              The piece of an edge a b is the quadrilateral a A B b, on its right. The piece
//        +----------------+              of a corner where the walk turns left is a sector from the side of one edge to
//        |                | . arc        that of the next. As chains, the walk and the boundaries of all pieces add up
//        |                |   .          to one path along A B, the arc, and so on: the sides between pieces cancel.
//   a ---+----------------+ b  +         Where the walk turns right, the path goes by the corner itself.
//        walk              c
//
// So only this path is written. Its winding number is that of the walk, plus one for every piece that covers a place.
// That needs pieces with winding number 1: a piece that rounding folded is left out of the path, and the hull of its
// vertices is written as a contour of its own.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "buffer/walk.h"
#include "buffer/zone_shape.h"

namespace oblast::internal::buffering {

/// Contours as in a region set.
struct Outlines {
  Array<Point> points;
  Array<std::uint32_t> contour_ends;
  std::uint64_t corners = 0;
  std::uint64_t folded_pieces = 0;
};

void append_outline(const ZoneShape& shape, const Walk& walk, Outlines& outlines);

/// The contour alone, without pieces.
void append_bare(std::span<const Point> contour, Outlines& outlines);

/// The piece of a single point.
void append_point_outline(const ZoneShape& shape, const Point& at, Outlines& outlines);

}  // namespace oblast::internal::buffering
