// The order of directions around a node, exactly, by orientation and never by arctangent.
//
//             90  4               Counter-clockwise from just above -90 degrees: first the directions to
//           5  | /   3            lexicographically greater points (-90, 90], then the others. So at the
//            \ |/                 smallest vertex of a component the outer sector follows the last one.
//       6 -----x----- 2
//             /|\                 .
//           7  | 1
#pragma once

#include <oblast/point.h>

#include <cmath>

#include "exact/orientation.h"

namespace oblast::internal {

/// True when the direction from x to p comes before the direction from x to q. REQUIRES: p, q != x.
inline bool angularly_less(const Point& x, const Point& p, const Point& q) {
  const bool p_second_half = lexicographically_less(p, x), q_second_half = lexicographically_less(q, x);
  if (p_second_half != q_second_half) return q_second_half;
  return exact::orientation(x, p, q) > 0;
}

/// Grows with the angle of the direction from x to p in this order, from -1 to 3. REQUIRES: p != x.
inline double rough_angle(const Point& x, const Point& p) {
  const double dx = p.x - x.x, dy = p.y - x.y;
  const double slope = dy / (std::fabs(dx) + std::fabs(dy));
  // Without a branch: the outcome is hard to foresee.
  const int second_half = static_cast<int>(dx < 0) | (static_cast<int>(dx == 0) & static_cast<int>(dy < 0));
  return 2 * second_half + (1 - 2 * second_half) * slope;
}
/// Of two directions whose rough angles are further apart, the lesser one comes first: the differences, their sum, the
/// quotient and what is taken from 2 are rounded by 2^-53 of at most 3 each.
inline constexpr double rough_angle_error = 0x1p-48;

}  // namespace oblast::internal
