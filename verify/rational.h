// Exact rational points, and their correct rounding to doubles.
#pragma once

#include <oblast/point.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

namespace oblast::verify {

// Without expression templates, so `auto` and the conditional operator work as usual.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

/// A point with rational coordinates.
struct RationalPoint {
  Rational x;
  Rational y;

  RationalPoint() = default;
  RationalPoint(Rational x_, Rational y_) : x(std::move(x_)), y(std::move(y_)) {}
  explicit RationalPoint(const Point& p) : x(p.x), y(p.y) {}

  friend bool operator==(const RationalPoint&, const RationalPoint&) = default;
};

/// The double nearest to `value`, ties to even, 0.0 for zero (never -0.0).
/// REQUIRES: the result is zero or a normal double.
double round_to_nearest(const Rational& value);

/// numerator / denominator 2^exponent, rounded in the same way. The fraction need not be reduced.
/// REQUIRES: the denominator is positive; the result is zero or a normal double.
double round_quotient(Integer numerator, Integer denominator, int exponent);

/// The coordinate nearest to `value`: as round_to_nearest, but a magnitude below the domain becomes 0 or the smallest
/// magnitude of the domain, whichever is nearer (0 if both are equally near).
double round_into_domain(const Rational& value);

/// The common point of the closed segments ab and cd, if they have exactly one.
std::optional<RationalPoint> intersection_of_segments(const Point& a, const Point& b, const Point& c, const Point& d);

/// The square of the distance from `p` to the closed segment ab.
Rational squared_distance(const RationalPoint& p, const Point& a, const Point& b);

}  // namespace oblast::verify
