// Idea: with p = b - a and q = c - a the point is a + (q.y |p|^2 - p.y |q|^2, p.x |q|^2 - q.x |p|^2) / (2 p x q):
// degree 3 over 2, as the intersection of edges. The domain is made for products of three coordinates (expansion.h). As
// there, double-doubles settle it nearly always, and expansions the rest.
#include "exact/circumcentre.h"

#include <cmath>

#include "exact/double_double.h"
#include "exact/expansion.h"
#include "exact/expansion_product.h"
#include "exact/rounded_exactly.h"

namespace oblast::internal::exact {
namespace {

Pair negated(const Pair& p) { return {-p.high, -p.low}; }

/// a + numerator / denominator rounded to nearest; NaN where the bounds on the errors do not settle it.
double rounded(double a, const CrossProduct& numerator, const CrossProduct& denominator) {
  const Pair step = quotient(numerator.value, denominator.value);
  const double step_error =
      1.01 * (numerator.error + step.size() * denominator.error) / denominator.value.size() + pair_unit * step.size();
  double x, y, high, low;
  two_sum(a, step.high, x, y);
  y += step.low;
  fast_two_sum(x, y, high, low);
  return settled(high, low, step_error + 3 * pair_unit * (std::fabs(a) + step.size()));
}

template <int N>
Expansion<N> half_of(Expansion<N> e) {
  for (int i = 0; i < e.size; ++i) e.component[i] /= 2;
  return e;
}

Point by_expansions(const Point& a, const Point& b, const Point& c) {
  const Expansion<2> px = difference(b.x, a.x), py = difference(b.y, a.y);
  const Expansion<2> qx = difference(c.x, a.x), qy = difference(c.y, a.y);
  const Expansion<16> p_square = px * px + py * py, q_square = qx * qx + qy * qy;
  // The numerators are halved, which loses nothing (expansion.h), and so the denominator is not doubled.
  auto denominator = px * qy - py * qx;
  auto x = half_of(product(p_square, qy) - product(q_square, py));
  auto y = half_of(product(q_square, px) - product(p_square, qx));
  if (denominator.sign() < 0) {
    denominator = -denominator;
    x = -x;
    y = -y;
  }
  return {rounded_exactly(denominator * a.x + x, denominator), rounded_exactly(denominator * a.y + y, denominator)};
}

}  // namespace

Point circumcentre(const Point& a, const Point& b, const Point& c) {
  const Pair px = exact_difference(b.x, a.x), py = exact_difference(b.y, a.y);
  const Pair qx = exact_difference(c.x, a.x), qy = exact_difference(c.y, a.y);
  const CrossProduct denominator = cross_product(px, py, qx, qy);
  if (denominator.value.size() > 1e6 * denominator.error) {
    const CrossProduct twice{{2 * denominator.value.high, 2 * denominator.value.low}, 2 * denominator.error};
    // |p|^2 = px px - py (-py); its error is relative, so it adds little to the error of the products.
    const Pair p_square = cross_product(px, py, negated(py), px).value;
    const Pair q_square = cross_product(qx, qy, negated(qy), qx).value;
    CrossProduct x = cross_product(p_square, q_square, py, qy), y = cross_product(q_square, p_square, qx, px);
    x.error *= 3;
    y.error *= 3;
    const Point p{rounded(a.x, x, twice), rounded(a.y, y, twice)};
    if (!std::isnan(p.x) && !std::isnan(p.y)) return {p.x == 0 ? 0.0 : p.x, p.y == 0 ? 0.0 : p.y};
  }
  return by_expansions(a, b, c);
}

}  // namespace oblast::internal::exact
