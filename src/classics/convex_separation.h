// An exact check that two nearly convex contours meet at common vertices only.
#pragma once

#include <oblast/point.h>

#include "base/call_memory.h"

namespace oblast::internal::classics {

/// True if each edge of one contour and each edge of the other are disjoint, or identical, or share exactly one end.
/// Then `common_a` and `common_b` say for each vertex whether it is also a vertex of the other contour. Also false if a
/// contour has more than one smallest or largest vertex (rounding can bend a convex contour like this). Cost: linear.
bool separated(const Array<Point>& a, const Array<Point>& b, Array<bool>& common_a, Array<bool>& common_b);

}  // namespace oblast::internal::classics
