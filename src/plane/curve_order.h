// Sorts points along a Hilbert curve, so that points that are close in the plane are close in memory.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "base/large_pages.h"
#include "plane/box.h"

namespace oblast::internal {

/// The index of a point, and the position of its cell on the curve.
struct Keyed {
  std::uint32_t key;
  std::uint32_t index;
};

/// The indices of the points along the curve. Equal points are consecutive and have equal keys. The curve is adaptive:
/// if many points are in one of its 2^32 cells, it continues inside the box of that cell. So neighbours with the same
/// key may be in two cells. Cost: O(n) for coordinates of similar magnitude. Each factor of 2^16 in scale between
/// nested clusters adds one pass over the inner cluster.
LargeArray<Keyed> curve_order(std::span<const Point> points);

/// The indices of the boxes, sorted by their centres along the curve.
LargeArray<std::uint32_t> curve_order(std::span<const Box> boxes);

}  // namespace oblast::internal
