// The predicates once more, by whole numbers of any size (Boost.Multiprecision): slow, simple and
// independent of src/exact.
#pragma once

#include <oblast/point.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <span>
#include <vector>

namespace oblast::testing {

using Integer = boost::multiprecision::cpp_int;

struct IntegerPoint {
  Integer x, y;
};

/// The points times one power of two that makes all coordinates whole.
std::vector<IntegerPoint> to_integers(std::span<const Point> points);

/// Twice the signed area of a, b, c.
Integer doubled_area(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c);

int exact_orientation(const Point& a, const Point& b, const Point& c);

/// 1 when d is inside the circle through a, b, c (counter-clockwise).
int exact_in_circle(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace oblast::testing
