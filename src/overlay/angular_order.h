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

#include "exact/orientation.h"

namespace oblast {

/// True when the direction from x to p comes before the direction from x to q. REQUIRES: p, q != x.
inline bool angularly_less(const Point& x, const Point& p, const Point& q) {
  const bool p_second_half = lexicographically_less(p, x), q_second_half = lexicographically_less(q, x);
  if (p_second_half != q_second_half) return q_second_half;
  return exact::orientation(x, p, q) > 0;
}

}  // namespace oblast
