// Exact predicates on points that are not constructed: the crossing of two lines, each through two input points.
#pragma once

#include <oblast/point.h>

namespace oblast::internal::classics {

/// A directed line through two different points.
struct Line {
  Point p;
  Point q;
};

/// side_of_crossing is exact for coordinates of magnitude 0 or within [smallest, largest]. Its terms are products of
/// four differences: multiples of 2^-1008 below 2^808.
inline constexpr double crossing_smallest = 0x1p-200;
inline constexpr double crossing_largest = 0x1p+200;

/// The sign of the cross product of the directions: 1 if `b` turns left of `a`, 0 if they are parallel.
int turn(const Line& a, const Line& b);

/// On which side of `line` the crossing of a and b lies: 1 left, -1 right, 0 on it.
/// REQUIRES: a and b are not parallel; coordinates in the range above.
int side_of_crossing(const Line& a, const Line& b, const Line& line);

}  // namespace oblast::internal::classics
