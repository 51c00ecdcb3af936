// The estimate of a distance from p to a segment from a to b: differences of coordinates have a relative error of at
// most u = 2^-53, so cross product and dot product of b - a and p - a are wrong by less than 6 u |p - a| |b - a|. The
// quotient by |b - a| adds 3 u of itself. If the wrong end or the line is taken because the dot product has the wrong
// sign, the foot is off by less than 6 u |p - a| again. Altogether less than 32 u times the distance to the further
// end.
#include "verify/distance.h"

#include <algorithm>
#include <cmath>

namespace oblast::verify {

Interval estimated_distance(const Point& p, const Stroke& s) {
  const double ex = s.b.x - s.a.x, ey = s.b.y - s.a.y, dx = p.x - s.a.x, dy = p.y - s.a.y;
  const double fx = p.x - s.b.x, fy = p.y - s.b.y;
  const double along = dx * ex + dy * ey, length_2 = ex * ex + ey * ey;
  const double from_a = std::sqrt(dx * dx + dy * dy), from_b = std::sqrt(fx * fx + fy * fy);
  double value = 0;
  if (along <= 0 || length_2 == 0)
    value = from_a;
  else if (along >= length_2)
    value = from_b;
  else
    value = std::abs(dx * ey - dy * ex) / std::sqrt(length_2);
  const double error = 0x1p-48 * std::max(from_a, from_b);
  return {std::max(0.0, value - error), value + error};
}

// sqrt(a) <= sqrt(b) + e if and only if a - b - e^2 <= 2 e sqrt(b). If the left side is not negative, both can be
// squared.
bool root_is_within(const Rational& a, const Rational& b, const Rational& e) {
  const Rational left = a - b - e * e;
  return left <= 0 || left * left <= 4 * e * e * b;
}

}  // namespace oblast::verify
