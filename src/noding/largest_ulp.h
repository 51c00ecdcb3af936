// The unit in the last place of the largest coordinate: what displacements and clearances are measured in.
#pragma once

#include <oblast/domain.h>
#include <oblast/point.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace oblast::noding {

inline double largest_coordinate(std::span<const Point> points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return largest;
}

/// Of a coordinate of the domain; 0 counts as the smallest.
inline double ulp_of(double coordinate) {
  return std::ldexp(1.0, std::ilogb(std::max(coordinate, domain_smallest)) - 52);
}

}  // namespace oblast::noding
