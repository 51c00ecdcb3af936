// The unit in the last place of the largest coordinate: what displacements and clearances are measured in.
//
// A crossing is put into the domain, too: one nearer to an axis than its smallest magnitude moves by up to half of
// that. So near the lower end of the domain this magnitude is the unit.
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

/// Of a coordinate of the domain; a crossing moves by no more than half of it in either coordinate.
inline double ulp_of(double coordinate) {
  return std::max(std::ldexp(1.0, std::ilogb(std::max(coordinate, domain_smallest)) - 52), domain_smallest);
}

}  // namespace oblast::noding
