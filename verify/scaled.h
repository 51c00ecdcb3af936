// Doubles as integers on a common scale: exact sums and products without fractions.
//
// A double is m 2^e, with an integer m of 53 bits. In units of 2^e for the smallest e, every coordinate is an integer.
// In the domain e is from -352 to 248, so coordinates have at most 653 bits, and a determinant of differences has at
// most 1310. WideInteger can hold it without allocating memory.
#pragma once

#include <oblast/point.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <span>

namespace oblast::verify {

using WideInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1408, 1408, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// A point in units of a scale.
struct ScaledPoint {
  WideInteger x;
  WideInteger y;
};

/// The unit of a set of doubles: a power of two of which all of them are multiples.
class Scale {
 public:
  /// REQUIRES: coordinates are in the domain.
  explicit Scale(std::span<const Point> points);

  /// The unit is 2 to this power.
  int exponent() const { return exponent_; }

  ScaledPoint operator()(const Point& p) const { return {scaled(p.x), scaled(p.y)}; }

 private:
  WideInteger scaled(double value) const;

  int exponent_;
};

/// (q - p) x (r - p): twice the area of the triangle, in square units.
WideInteger determinant(const ScaledPoint& p, const ScaledPoint& q, const ScaledPoint& r);

}  // namespace oblast::verify
