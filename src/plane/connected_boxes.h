// Connected boxes: two that meet, directly or by way of others.
#pragma once

#include <cstdint>

#include "base/large_pages.h"
#include "plane/box.h"

namespace oblast::internal {

struct ConnectedBoxes {
  LargeArray<std::uint32_t> order;      ///< the boxes by their middles along a curve, so that neighbours stay together
  LargeArray<std::uint32_t> component;  ///< by box: a number below the count of boxes, the same for connected ones
};

/// Where so many boxes lie upon each other that to tell them apart takes too long, all there count as connected; else
/// only those are that must be. The same on any number of cores. Cost: O(n log n); memory O(n).
ConnectedBoxes connected_boxes(LargeArray<Box> boxes);

}  // namespace oblast::internal
