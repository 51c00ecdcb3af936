// Idea: with r = b - a, s = d - c, w = c - a the point is a + r (w x s) / (r x s). Double-double
// arithmetic with a running error bound gives it to about 100 bits, which settles the rounding nearly
// always. When the bound leaves two candidates, the comparison of the exact rational with the midpoint
// between them, by expansions, decides.
#include "exact/intersection_point.h"

#include <oblast/domain.h>

#include <cmath>
#include <limits>

#include "exact/expansion.h"

namespace oblast::exact {
namespace {

/// A double-double with a bound on its absolute error.
struct Bounded {
  double high;
  double low;
  double error;
};

// Relative error of one double-double operation, generously: the true constants are below 8 * 2^-106.
constexpr double unit = 0x1p-100;

Bounded exact_difference(double a, double b) {
  Bounded r{0, 0, 0};
  two_diff(a, b, r.high, r.low);
  return r;
}

Bounded product(const Bounded& p, const Bounded& q) {
  double x, y, high, low;
  two_product(p.high, q.high, x, y);
  y += p.high * q.low + p.low * q.high;
  fast_two_sum(x, y, high, low);
  const double p_size = std::fabs(p.high), q_size = std::fabs(q.high);
  return {high, low, (p.error * q_size + q.error * p_size + p.error * q.error) * 1.01 + unit * (p_size * q_size)};
}

Bounded difference_of(const Bounded& p, const Bounded& q) {
  double x, y, high, low;
  two_diff(p.high, q.high, x, y);
  y += p.low - q.low;
  fast_two_sum(x, y, high, low);
  return {high, low, (p.error + q.error) * 1.01 + unit * (std::fabs(p.high) + std::fabs(q.high))};
}

/// REQUIRES: q.error well below |q.high|.
Bounded quotient(const Bounded& p, const Bounded& q) {
  const double first = p.high / q.high;
  double x, y;
  two_product(first, q.high, x, y);
  const double rest = ((p.high - x) - y + p.low - first * q.low) / q.high;
  double high, low;
  fast_two_sum(first, rest, high, low);
  const double size = std::fabs(first), denominator = std::fabs(q.high) - q.error;
  return {high, low, ((p.error + size * q.error) / denominator) * 1.01 + unit * size};
}

/// a + t * r rounded to nearest; NaN when the bound does not settle it.
double rounded(double a, const Bounded& t, const Bounded& r) {
  const Bounded step = product(t, r);
  double x, y, high, low;
  two_sum(a, step.high, x, y);
  y += step.low;
  fast_two_sum(x, y, high, low);
  const double error = step.error * 1.01 + unit * (std::fabs(a) + std::fabs(step.high));
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
  const Bounded rx = exact_difference(b.x, a.x), ry = exact_difference(b.y, a.y);
  const Bounded sx = exact_difference(d.x, c.x), sy = exact_difference(d.y, c.y);
  const Bounded wx = exact_difference(c.x, a.x), wy = exact_difference(c.y, a.y);
  const Bounded denominator = difference_of(product(rx, sy), product(ry, sx));
  if (std::fabs(denominator.high) > 1e6 * denominator.error) {
    const Bounded t = quotient(difference_of(product(wx, sy), product(wy, sx)), denominator);
    const Point p{rounded(a.x, t, rx), rounded(a.y, t, ry)};
    if (p.x == p.x && p.y == p.y) return {p.x == 0 ? 0.0 : p.x, p.y == 0 ? 0.0 : p.y};
  }
  return by_expansions(a, b, c, d);
}

}  // namespace oblast::exact
