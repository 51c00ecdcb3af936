// Double-double arithmetic with bounds on its errors: about 100 bits, which settle the rounding of a construction
// nearly always.
#pragma once

#include <oblast/domain.h>

#include <cmath>
#include <limits>

#include "exact/expansion.h"

namespace oblast::internal::exact {

/// A double-double.
struct Pair {
  double high;
  double low;

  double size() const { return std::fabs(high); }
};

// Relative error of one operation below, generously: the true constants are below 8 * 2^-106. Where terms are
// subtracted it is relative to the sum of their sizes.
inline constexpr double pair_unit = 0x1p-100;

inline Pair exact_difference(double a, double b) {
  Pair r;
  two_diff(a, b, r.high, r.low);
  return r;
}

inline Pair product(const Pair& p, const Pair& q) {
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

inline CrossProduct cross_product(const Pair& px, const Pair& py, const Pair& qx, const Pair& qy) {
  const Pair left = product(px, qy), right = product(py, qx);
  double x, y;
  two_diff(left.high, right.high, x, y);
  y += left.low - right.low;
  CrossProduct r;
  fast_two_sum(x, y, r.value.high, r.value.low);
  r.error = 3 * pair_unit * (left.size() + right.size());
  return r;
}

inline Pair quotient(const Pair& p, const Pair& q) {
  const double first = p.high / q.high;
  double x, y;
  two_product(first, q.high, x, y);
  const double rest = ((p.high - x) - y + p.low - first * q.low) / q.high;
  Pair r;
  fast_two_sum(first, rest, r.high, r.low);
  return r;
}

/// high + low, if the rounding is the same for all numbers within `error` of it, and is not affected by the lower end
/// of the domain; else NaN.
inline double settled(double high, double low, double error) {
  if (high + (low + error) == high + (low - error) && (high == 0 || std::fabs(high) > domain_smallest)) return high;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace oblast::internal::exact
