// Exact predicates: doubles with an error bound first, exact integers where they cannot decide.
#include "verify/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/scaled.h"

namespace oblast::verify {
namespace {

int sign(double x) { return (x > 0) - (x < 0); }

// True if the rounded difference d = p - q is exact: both operands can be restored from it.
bool exact_difference(double p, double q, double d) {
  const double q_back = p - d;
  const double p_back = q_back + d;
  return p_back == p && q_back == q;
}

int side_by_integers(const Point& a, const Point& b, const Point& c) {
  const Scale scale(std::array{a, b, c});
  return determinant(scale(a), scale(b), scale(c)).sign();
}

}  // namespace

// The determinant is left - right, left = (bx - ax)(cy - ay), right = (by - ay)(cx - ax).
//
// In the domain, a difference of two coordinates is 0, or at least 2^-352 and at most 2^301. So the products neither
// underflow nor overflow. Each difference and product has a relative error of at most e = 2^-53. So each product is
// within a factor (1 + e)^3 of the exact value, and the final subtraction adds another factor. The total error is below
// (4e + O(e^2)) (|left| + |right|) < 8e (|left| + |right|).
int side_of_line(const Point& a, const Point& b, const Point& c) {
  if (a == c || b == c || a == b) return 0;
  const double abx = b.x - a.x, aby = b.y - a.y;
  const double acx = c.x - a.x, acy = c.y - a.y;
  const double left = abx * acy;
  const double right = aby * acx;
  const double determinant = left - right;
  if (std::abs(determinant) > 0x1p-50 * (std::abs(left) + std::abs(right))) return sign(determinant);

  // Small integers and points on a line along an axis are decided here: all six operations were exact.
  if (exact_difference(b.x, a.x, abx) && exact_difference(b.y, a.y, aby) && exact_difference(c.x, a.x, acx) &&
      exact_difference(c.y, a.y, acy) && std::fma(abx, acy, -left) == 0 && std::fma(aby, acx, -right) == 0) {
    return (left > right) - (left < right);
  }
  return side_by_integers(a, b, c);
}

bool meet_badly(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
    return false;
  }
  if ((a == c && b == d) || (a == d && b == c)) return true;
  if (a == c) return same_direction(a, b, d);
  if (a == d) return same_direction(a, b, c);
  if (b == c) return same_direction(b, a, d);
  if (b == d) return same_direction(b, a, c);

  // Four different end points. The boxes meet, so collinear segments overlap (the box is the projection on both axes).
  // Other segments meet if neither has both ends on one side of the other.
  const int c_side = side_of_line(a, b, c), d_side = side_of_line(a, b, d);
  if (c_side * d_side > 0) return false;
  const int a_side = side_of_line(c, d, a), b_side = side_of_line(c, d, b);
  return a_side * b_side <= 0;
}

bool same_direction(const Point& u, const Point& a, const Point& b) {
  if (side_of_line(u, a, b) != 0) return false;
  // On one line through u: the same direction unless u lies between them.
  return sign(a.x - u.x) == sign(b.x - u.x) && sign(a.y - u.y) == sign(b.y - u.y);
}

bool stands_below(const Point& e_left, const Point& e_right, const Point& f_left, const Point& f_right) {
  if (e_left == f_left) return side_of_line(e_left, e_right, f_right) > 0;
  if (lexicographically_less(e_left, f_left)) return side_of_line(e_left, e_right, f_left) > 0;
  return side_of_line(f_left, f_right, e_left) < 0;
}

bool angle_less(const Point& u, const Point& a, const Point& b) {
  // Lower half: (-pi, 0), upper half: [0, pi].
  const auto upper = [&](const Point& p) { return p.y >= u.y; };
  const bool a_upper = upper(a), b_upper = upper(b);
  if (a_upper != b_upper) return b_upper;
  const int side = side_of_line(u, a, b);
  if (side != 0) return side > 0;
  // On one line in one half: the same direction, or the two ends of the upper half, 0 and pi.
  return a.x > u.x && b.x < u.x;
}

}  // namespace oblast::verify
