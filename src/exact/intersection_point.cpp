// Idea: with r = b - a, s = d - c, w = c - a the point is a + r (w x s) / (r x s). Double-double
// arithmetic with a running error bound gives it to about 100 bits, which settles the rounding nearly
// always. When the bound leaves two candidates, the comparison of the exact rational with the midpoint
// between them, by expansions, decides.
#include "exact/intersection_point.h"

#include <cmath>

#include "exact/double_double.h"
#include "exact/expansion.h"
#include "exact/rounded_exactly.h"

namespace oblast::internal::exact {
namespace {

/// a + t * r rounded to nearest; NaN when the bound on the error of t does not settle it.
double rounded(double a, const Pair& t, double t_error, const Pair& r) {
  const Pair step = product(t, r);
  double x, y, high, low;
  two_sum(a, step.high, x, y);
  y += step.low;
  fast_two_sum(x, y, high, low);
  const double error = 1.01 * t_error * r.size() + 3 * pair_unit * (std::fabs(a) + step.size());
  return settled(high, low, error);
}

Point by_expansions(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Expansion<2> rx = difference(b.x, a.x), ry = difference(b.y, a.y);
  const Expansion<2> sx = difference(d.x, c.x), sy = difference(d.y, c.y);
  const Expansion<2> wx = difference(c.x, a.x), wy = difference(c.y, a.y);
  auto denominator = rx * sy - ry * sx;
  auto numerator = wx * sy - wy * sx;
  if (denominator.sign() < 0) {
    denominator = -denominator;
    numerator = -numerator;
  }
  return {rounded_exactly(denominator * a.x + numerator * rx, denominator),
          rounded_exactly(denominator * a.y + numerator * ry, denominator)};
}

}  // namespace

Point intersection_point(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Pair rx = exact_difference(b.x, a.x), ry = exact_difference(b.y, a.y);
  const Pair sx = exact_difference(d.x, c.x), sy = exact_difference(d.y, c.y);
  const Pair wx = exact_difference(c.x, a.x), wy = exact_difference(c.y, a.y);
  const CrossProduct denominator = cross_product(rx, ry, sx, sy);
  if (denominator.value.size() > 1e6 * denominator.error) {
    const CrossProduct numerator = cross_product(wx, wy, sx, sy);
    const Pair t = quotient(numerator.value, denominator.value);
    const double t_error =
        1.01 * (numerator.error + t.size() * denominator.error) / denominator.value.size() + pair_unit * t.size();
    const Point p{rounded(a.x, t, t_error, rx), rounded(a.y, t, t_error, ry)};
    if (!std::isnan(p.x) && !std::isnan(p.y)) return {p.x == 0 ? 0.0 : p.x, p.y == 0 ? 0.0 : p.y};
  }
  return by_expansions(a, b, c, d);
}

}  // namespace oblast::internal::exact
