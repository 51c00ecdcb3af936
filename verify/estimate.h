// A number with a bound of its error. It decides most tests; exact rationals decide the others.
//
// Works with any long double that is at least as precise as a double. If long double is double, rationals decide more
// tests.
#pragma once

#include <cmath>
#include <limits>

#include "verify/rational.h"

namespace oblast::verify {

/// The true number lies in [value - error, value + error].
struct Estimate {
  long double value = 0;
  long double error = 0;

  Estimate() = default;
  Estimate(double exact) : value(exact) {}  // a double is an estimate without error
  Estimate(long double v, long double e) : value(v), error(e) {}

  long double least() const { return value - error; }
  long double most() const { return value + error; }
  bool certainly_positive() const { return value > error; }
};

// Adds twice the rounding error of an operation, to include the rounding of least() and most(). A factor compensates
// for the rounding of the error itself.
inline Estimate with_rounding(long double value, long double error) {
  constexpr long double unit = 2 * std::numeric_limits<long double>::epsilon();
  return {value, (error + std::abs(value) * unit) * (1 + 0x1p-20L)};
}

inline Estimate operator+(const Estimate& a, const Estimate& b) {
  return with_rounding(a.value + b.value, a.error + b.error);
}
inline Estimate operator-(const Estimate& a, const Estimate& b) {
  return with_rounding(a.value - b.value, a.error + b.error);
}
inline Estimate operator*(const Estimate& a, const Estimate& b) {
  return with_rounding(a.value * b.value,
                       std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
}
inline Estimate operator/(const Estimate& a, const Estimate& b) {
  const long double least = std::abs(b.value) - b.error;
  if (!(least > 0)) return {0, std::numeric_limits<long double>::infinity()};
  const long double quotient = a.value / b.value;
  return with_rounding(quotient, (a.error + std::abs(quotient) * b.error) / least);
}

/// True if a is certainly less than b; false if this is unknown.
inline bool certainly_less(const Estimate& a, const Estimate& b) { return a.most() < b.least(); }

struct EstimatedPoint {
  Estimate x;
  Estimate y;

  EstimatedPoint() = default;
  EstimatedPoint(const Estimate& x_, const Estimate& y_) : x(x_), y(y_) {}
  explicit EstimatedPoint(const Point& p) : x(p.x), y(p.y) {}
};

/// The intersection of the lines through ab and cd. The error is infinite if they may be parallel.
inline EstimatedPoint estimated_crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Estimate dx1 = Estimate(b.x) - Estimate(a.x), dy1 = Estimate(b.y) - Estimate(a.y);
  const Estimate dx2 = Estimate(d.x) - Estimate(c.x), dy2 = Estimate(d.y) - Estimate(c.y);
  const Estimate px = Estimate(c.x) - Estimate(a.x), py = Estimate(c.y) - Estimate(a.y);
  const Estimate t = (px * dy2 - py * dx2) / (dx1 * dy2 - dy1 * dx2);
  return {Estimate(a.x) + t * dx1, Estimate(a.y) + t * dy1};
}

}  // namespace oblast::verify
