// An exact check that two nearly convex contours meet at common vertices only.
#pragma once

#include <oblast/point.h>

#include "base/call_memory.h"

namespace oblast::internal::classics {

/// True when each edge of one contour and each of the other are disjoint, or identical, or share just one end.
/// False also where a contour has more than one smallest or largest vertex (rounding may bend a convex contour so).
/// Then `common_a` and `common_b` tell for each vertex whether it is one of the other contour's. Cost: linear.
bool separated(const Array<Point>& a, const Array<Point>& b, Array<bool>& common_a, Array<bool>& common_b);

}  // namespace oblast::internal::classics
