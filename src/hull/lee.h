// Lee's hull of a simple polygon, and the monotone chain.
#pragma once

#include <oblast/point.h>

#include <span>

#include "base/call_memory.h"

namespace oblast::internal {

/// The corners of the hull, counter-clockwise from the smallest vertex. `direction`: 1 for a counter-clockwise ring, -1
/// for a clockwise one. The result is the hull if the ring is simple. REQUIRES: at least three vertices, no repeated
/// neighbours. Cost: linear.
Array<Point> lee_hull(std::span<const Point> ring, int direction);

/// The hull of any points, counter-clockwise from the smallest (Andrew 1979). Sorts `points`. Cost: O(n log n).
Array<Point> monotone_chain_hull(Array<Point>& points);

}  // namespace oblast::internal
