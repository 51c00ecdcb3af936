// The in-circle test, exactly: the predicate by which a triangulation is Delaunay.
//
//          c --- b
//         (   d   )              in_circle(a, b, c, d) > 0: d is inside the circle through a, b, c
//          \     /               laws: even permutations of the four keep the sign, odd ones turn it;
//            -a-                       == 0 exactly when the four lie on one circle or line
//
// Degree 4 in the coordinates, so in the domain (oblast/domain.h) the products may leave the range of
// doubles on either side; in_circle.cpp says what is done then.
#pragma once

#include <oblast/point.h>

#include <cmath>

namespace oblast::internal::exact {

/// The sign by exact arithmetic; called when the filter cannot decide.
int in_circle_exact(const Point& a, const Point& b, const Point& c, const Point& d);

/// REQUIRES: a, b, c turn left (else the sign is reversed). Returns 1 (d inside the circle), -1 (outside)
/// or 0 (on it).
///
/// The filter. With u = 2^-53 every number below is a sum of products of differences; a difference
/// carries a factor (1 + e), |e| <= u, and each later rounding another. A square sum carries four (two
/// differences, a product, a sum), a 2 x 2 minor four, their product one more: nine; the sum of three such
/// terms two more: eleven. So |computed - true| <= ((1 + u)^11 - 1) P with P the sum of the absolute
/// terms, and P <= (1 + u)^11 of the computed one: below 11.001 u P, and 12 u P covers the rounding of
/// the bound itself. Overflow makes P infinite and both comparisons false. Underflow: differences are multiples of
/// 2^-352, so squares and minors are multiples of 2^-704 and exactly representable as such; only the last
/// three products can underflow, each by at most 2^-1075: far below any bound above 2^-1000.
inline int in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  const double bc = bdx * cdy, cb = cdx * bdy;
  const double ca = cdx * ady, ac = adx * cdy;
  const double ab = adx * bdy, ba = bdx * ady;
  const double a_square = adx * adx + ady * ady;
  const double b_square = bdx * bdx + bdy * bdy;
  const double c_square = cdx * cdx + cdy * cdy;
  const double determinant = a_square * (bc - cb) + b_square * (ca - ac) + c_square * (ab - ba);
  const double permanent = a_square * (std::fabs(bc) + std::fabs(cb)) + b_square * (std::fabs(ca) + std::fabs(ac)) +
                           c_square * (std::fabs(ab) + std::fabs(ba));
  constexpr double bound = 12 * 0x1p-53;
  const double error = bound * permanent;
  if (error > 0x1p-1000) {
    if (determinant > error) return 1;
    if (-determinant > error) return -1;
  }
  return in_circle_exact(a, b, c, d);
}

}  // namespace oblast::internal::exact
