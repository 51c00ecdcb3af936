// The unit in the last place of the largest coordinate: what displacements and clearances are measured in.
//
// A crossing is put into the domain, too: one nearer to an axis than its smallest magnitude moves by up to half of
// that. So near the lower end of the domain this magnitude is the unit.
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

/// Of a coordinate of the domain; a crossing moves by no more than half of it in either coordinate.
/// By the bits of its exponent: this is asked for every run.
inline double ulp_of(double coordinate) {
  constexpr std::uint64_t exponent_bits = 0x7ff0'0000'0000'0000;
  const auto bits = std::bit_cast<std::uint64_t>(std::max(coordinate, domain_smallest));
  return std::max(std::bit_cast<double>(bits & exponent_bits) * 0x1p-52, domain_smallest);
}

}  // namespace oblast::internal
