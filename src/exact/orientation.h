// The orientation of three points, exactly: the one predicate that every stage decides by.
//
//            c                orientation(a, b, c) > 0: c is left of the line from a to b
//           /                 laws: orientation(a,b,c) == orientation(b,c,a) == -orientation(b,a,c)
//     a ---+----> b                 == 0 exactly when the three are collinear
#pragma once

#include <oblast/point.h>

#include <cmath>

#include "base/arithmetic.h"

namespace oblast::internal::exact {

/// The sign by expansion arithmetic; called when the filter cannot decide.
int orientation_exact(const Point& a, const Point& b, const Point& c);

/// Sign of the doubled area of the triangle a, b, c: 1 (left turn), -1 (right turn) or 0 (collinear).
///
/// The filter. With u = 2^-53, each difference carries a relative error of at most u, each product
/// then (1 + u)^3 - 1, and the last subtraction another u of the result, so
///   |computed - true| <= (3u + 3u^2 + u^3)(1 + u)(|left| + |right|) + u |computed|,
/// which is below (3 + 16u) u (|left| + |right|), evaluated in floating point. Nothing underflows
/// inside the domain. A zero difference is exact, so collinear axis-parallel triples give bound 0 and
/// are decided here: hence `>=`.
inline int orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  constexpr double bound = 3.3306690738754716e-16;  // (3 + 16u) u
  const double error = bound * (std::fabs(left) + std::fabs(right));
  if (determinant >= error && determinant != 0) return 1;
  if (-determinant >= error && determinant != 0) return -1;
  if (error == 0) return 0;
  return orientation_exact(a, b, c);
}

}  // namespace oblast::internal::exact
