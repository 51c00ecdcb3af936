// Which of many boxes hold a point of another one: what asks for a point-in-region query, and what can answer it.
//
// Points are put into the cells of a grid; a box looks at the points of the cells it covers. Where boxes cover so much
// of the grid that this is no gain, all are taken to hold points and to be held.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "plane/box.h"

namespace oblast::internal {

struct Enclosure {
  Array<std::uint8_t> encloses;  ///< by box: it holds the point of another (or it is not known)
  Array<std::uint8_t> enclosed;  ///< by box: its point is in another (or it is not known)
};

/// REQUIRES: points[i] in boxes[i]. Cost: O(n).
Enclosure find_enclosing(std::span<const Box> boxes, std::span<const Point> points);

}  // namespace oblast::internal
