// The order in which points are inserted: rounds of growing size, each along a Hilbert curve.
//
// Reference: N. Amenta, S. Choi, G. Rote, "Incremental Constructions con BRIO", 2003. A point is in the
// last round with probability 7/8, in the one before with 7/64, and so on (drawn from a hash of its
// index, so the order is the same on every machine). The random rounds keep the expected number of changes
// linear whatever the distribution; the curve keeps the walk from one point to the next short.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"

namespace oblast::internal::triangulation {

/// A permutation of the indices of `points`. The curve adapts: where many points fall in one of its 2^32
/// cells, it goes on inside that cell's box. Cost: O(n), for coordinates of like magnitude; each factor of
/// 2^16 in scale between nested clusters adds one more pass over the inner one.
Array<std::uint32_t> spatial_order(std::span<const Point> points);

}  // namespace oblast::internal::triangulation
