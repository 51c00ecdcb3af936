// Points along a Hilbert curve: what is near in the plane becomes near in memory.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "base/large_pages.h"
#include "plane/box.h"

namespace oblast::internal {

/// A point's index, and its cell's place on the curve.
struct Keyed {
  std::uint32_t key;
  std::uint32_t index;
};

/// The indices of the points along the curve; equal points follow one another with equal keys. The curve adapts: where
/// many points fall in one of its 2^32 cells, it goes on inside that cell's box, so neighbours of one key may be of
/// two cells. Cost: O(n), for coordinates of like magnitude; each factor of 2^16 in scale between nested clusters adds
/// one more pass over the inner one.
LargeArray<Keyed> curve_order(std::span<const Point> points);

/// The indices of the boxes by their middles along the curve.
LargeArray<std::uint32_t> curve_order(std::span<const Box> boxes);

}  // namespace oblast::internal
