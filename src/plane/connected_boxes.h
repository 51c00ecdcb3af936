// Connected boxes: two boxes are connected if they meet, directly or through others.
#pragma once

#include <cstdint>

#include "base/large_pages.h"
#include "plane/box.h"

namespace oblast::internal {

struct ConnectedBoxes {
  LargeArray<std::uint32_t> order;      ///< the boxes, sorted by their centres along a curve
  LargeArray<std::uint32_t> component;  ///< by box: a number below the number of boxes; the same for connected boxes
};

/// If so many boxes overlap that a decision takes too long, all boxes there count as connected. Otherwise only boxes
/// that are connected. The result does not depend on the number of cores. Cost: O(n log n) time, O(n) memory.
ConnectedBoxes connected_boxes(LargeArray<Box> boxes);

}  // namespace oblast::internal
