// Exact rational points, and the correctly rounded way back to doubles.
#pragma once

#include <oblast/point.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

namespace oblast::verify {

// Without expression templates: `auto` and ternaries then mean what they say.
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

/// The coordinate nearest to `value`: round_to_nearest, but a magnitude below the domain becomes 0 or the domain's
/// smallest, whichever is nearer, 0 where both are.
double round_into_domain(const Rational& value);

/// The one point where the lines through ab and cd meet, if the closed segments meet in exactly one point.
std::optional<RationalPoint> intersection_of_segments(const Point& a, const Point& b, const Point& c, const Point& d);

/// The square of the distance from `p` to the closed segment ab.
Rational squared_distance(const RationalPoint& p, const Point& a, const Point& b);

}  // namespace oblast::verify
