// Rings in a form in which the same ones are equal: from the smallest vertex on, in one direction.
#pragma once

#include <oblast/point.h>

#include <span>

#include "base/call_memory.h"

namespace oblast::internal::repairing {

/// A ring from its smallest vertex on.
using Ring = Array<Point>;

/// Vertices that a ring of the resolved region has and the feature's has not, though they are exactly on its edges.
enum class MoreVertices { allowed, refused };

/// Clockwise if it is a hole, else counter-clockwise. Empty if the ring cannot be one of a valid polygon. Cost: linear.
Ring ring_in_order(std::span<const Point> ring, bool is_hole);

/// By the first vertex, then by the direction of the first edge. REQUIRES: rings of one direction.
bool comes_before(const Ring& p, const Ring& q);

/// Cost: linear.
bool is_same_ring(const Ring& ring, const Ring& resolved, MoreVertices more);

}  // namespace oblast::internal::repairing
