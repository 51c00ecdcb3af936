// Finds which of many boxes contain a point of another box. Only these need a point-in-region query, or can answer one.
//
// The points are put into the cells of a grid. A box tests the points in the cells that it covers. If boxes cover so
// much of the grid that this saves nothing, all boxes count as enclosing and as enclosed.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "plane/box.h"

namespace oblast::internal {

struct Enclosure {
  Array<std::uint8_t> encloses;  ///< by box: it contains the point of another box (or this is unknown)
  Array<std::uint8_t> enclosed;  ///< by box: its point is in another box (or this is unknown)
};

/// REQUIRES: points[i] is in boxes[i]. Cost: O(n).
Enclosure find_enclosing(std::span<const Box> boxes, std::span<const Point> points);

}  // namespace oblast::internal
