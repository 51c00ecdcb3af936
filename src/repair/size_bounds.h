// Whether a piece is small: below a bound of its area or of its width.
#pragma once

#include <oblast/region_set.h>

#include "repair/exact_sum.h"

namespace oblast::internal::repairing {

struct SizeBounds {
  double area, width;  ///< 0: nothing is below; infinity: everything is

  bool empty() const { return area == 0 && width == 0; }
};

/// `twice_area`: of the piece, which is canonical. The area is compared exactly; the width, twice the area by the
/// perimeter, in doubles, the perimeter added edge by edge. Cost: linear.
bool is_below(const SizeBounds& bounds, const RegionView& piece, const ExactSum& twice_area);

/// The square root of what this gives is correctly rounded, so lengths are the same on every machine.
double edge_length(const Point& p, const Point& q);

}  // namespace oblast::internal::repairing
