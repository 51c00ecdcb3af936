// The order in which points are inserted: rounds of growing size, each along a Hilbert curve.
//
// Reference: N. Amenta, S. Choi, G. Rote, "Incremental Constructions con BRIO", 2003. A point is in the last round with
// probability 7/8, in the round before with 7/64, and so on. A hash of its index decides, so the order is the same on
// every machine. Because rounds are random, the expected number of changes is linear for any distribution. Because of
// the curve, the walk from one point to the next is short.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"

namespace oblast::internal::triangulation {

/// A permutation of the indices of `points`. The curve is adaptive: if many points are in one of its 2^32 cells, it
/// continues inside the box of that cell. Cost: O(n) for coordinates of similar magnitude. Each factor of 2^16 in scale
/// between nested clusters adds one pass over the inner cluster.
Array<std::uint32_t> spatial_order(std::span<const Point> points);

}  // namespace oblast::internal::triangulation
