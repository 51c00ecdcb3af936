// Idea: with r = b - a, s = d - c, w = c - a the point is a + r (w x s) / (r x s). Double-double
// arithmetic with a running error bound gives it to about 100 bits, which settles the rounding nearly
// always. When the bound leaves two candidates, the comparison of the exact rational with the midpoint
// between them, by expansions, decides.
#include "exact/intersection_point.h"

#include <oblast/domain.h>

#include <cmath>
#include <limits>

#include "exact/expansion.h"

namespace oblast::internal::exact {
namespace {

/// A double-double.
struct Pair {
  double high;
  double low;

  double size() const { return std::fabs(high); }
};

// Relative error of one operation below, generously: the true constants are below 8 * 2^-106. Where terms are
// subtracted it is relative to the sum of their sizes.
constexpr double unit = 0x1p-100;

Pair exact_difference(double a, double b) {
  Pair r;
  two_diff(a, b, r.high, r.low);
  return r;
}

Pair product(const Pair& p, const Pair& q) {
  double x, y;
  two_product(p.high, q.high, x, y);
  y += p.high * q.low + p.low * q.high;
  Pair r;
  fast_two_sum(x, y, r.high, r.low);
  return r;
}

/// p x q, and a bound on its absolute error.
struct CrossProduct {
  Pair value;
  double error;
};

CrossProduct cross_product(const Pair& px, const Pair& py, const Pair& qx, const Pair& qy) {
  const Pair left = product(px, qy), right = product(py, qx);
  double x, y;
  two_diff(left.high, right.high, x, y);
  y += left.low - right.low;
  CrossProduct r;
  fast_two_sum(x, y, r.value.high, r.value.low);
  r.error = 3 * unit * (left.size() + right.size());
  return r;
}

Pair quotient(const Pair& p, const Pair& q) {
  const double first = p.high / q.high;
  double x, y;
  two_product(first, q.high, x, y);
  const double rest = ((p.high - x) - y + p.low - first * q.low) / q.high;
  Pair r;
  fast_two_sum(first, rest, r.high, r.low);
  return r;
}

/// a + t * r rounded to nearest; NaN when the bound on the error of t does not settle it.
double rounded(double a, const Pair& t, double t_error, const Pair& r) {
  const Pair step = product(t, r);
  double x, y, high, low;
  two_sum(a, step.high, x, y);
  y += step.low;
  fast_two_sum(x, y, high, low);
  const double error = 1.01 * t_error * r.size() + 3 * unit * (std::fabs(a) + step.size());
  if (high + (low + error) == high + (low - error) && (high == 0 || std::fabs(high) > domain_smallest)) return high;
  return std::numeric_limits<double>::quiet_NaN();
}

/// The next coordinate of the domain above x (below: negate twice).
double next_up(double x) {
  if (x >= 0 && x < domain_smallest) return domain_smallest;
  if (x < 0 && x >= -domain_smallest) return 0;
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

/// The exact rational numerator / denominator, denominator > 0, against the midpoint of p and q.
template <int N, int M>
int compare_with_midpoint(const Expansion<N>& numerator, const Expansion<M>& denominator, double p, double q) {
  double x, y;
  two_sum(p / 2, q / 2, x, y);
  Expansion<2> midpoint;
  midpoint.push(y);
  midpoint.push(x);
  return (numerator - denominator * midpoint).sign();
}

bool is_even(double x) {
  int exponent;
  return std::fmod(std::ldexp(std::frexp(x, &exponent), 53), 2.0) == 0;
}

template <int N, int M>
double rounded_exactly(const Expansion<N>& numerator, const Expansion<M>& denominator) {
  double x = numerator.estimate() / denominator.estimate();
  if (std::fabs(x) < domain_smallest) x = 0;
  for (;;) {
    const double above = next_up(x), below = -next_up(-x);
    const int up = compare_with_midpoint(numerator, denominator, x, above);
    if (up > 0 || (up == 0 && !is_even(x))) {
      x = above;
      if (up == 0) return x;
      continue;
    }
    const int down = compare_with_midpoint(numerator, denominator, x, below);
    if (down < 0 || (down == 0 && !is_even(x))) {
      x = below;
      if (down == 0) return x;
      continue;
    }
    return x == 0 ? 0.0 : x;
  }
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
        1.01 * (numerator.error + t.size() * denominator.error) / denominator.value.size() + unit * t.size();
    const Point p{rounded(a.x, t, t_error, rx), rounded(a.y, t, t_error, ry)};
    if (p.x == p.x && p.y == p.y) return {p.x == 0 ? 0.0 : p.x, p.y == 0 ? 0.0 : p.y};
  }
  return by_expansions(a, b, c, d);
}

}  // namespace oblast::internal::exact
