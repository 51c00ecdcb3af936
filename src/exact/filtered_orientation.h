// The filter of `orientation` alone, for who asks it without a branch and seldom needs more.
#pragma once

#include <oblast/point.h>

#include <cmath>

#include "base/arithmetic.h"

namespace oblast::internal::exact {

/// The same operations and bound as in `orientation`, which says why they are right.
struct FilteredOrientation {
  FilteredOrientation(const Point& a, const Point& b, const Point& c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    determinant = left - right;
    error = 3.3306690738754716e-16 * (std::fabs(left) + std::fabs(right));
  }

  /// Whether the sign of the determinant is that of the orientation, and neither is 0.
  bool is_certain() const { return std::fabs(determinant) > error; }
  bool is_left() const { return determinant > 0; }

  double determinant, error;
};

}  // namespace oblast::internal::exact
