// The unit in the last place of the largest coordinate. Displacements and clearances are measured in this unit.
//
// Crossings are also rounded to the domain: a crossing closer to an axis than the smallest magnitude moves by up to
// half of that magnitude. So near the lower end of the domain, this magnitude is the unit.
#pragma once

#include <oblast/domain.h>
#include <oblast/point.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

namespace oblast::internal {

inline double largest_coordinate(std::span<const Point> points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return largest;
}

/// The unit for a coordinate of the domain. Rounding moves a crossing by at most half of it in each coordinate.
/// Computed from the bits of the exponent, because every run needs it.
inline double ulp_of(double coordinate) {
  constexpr std::uint64_t exponent_bits = 0x7ff0'0000'0000'0000;
  const auto bits = std::bit_cast<std::uint64_t>(std::max(coordinate, domain_smallest));
  return std::max(std::bit_cast<double>(bits & exponent_bits) * 0x1p-52, domain_smallest);
}

}  // namespace oblast::internal
