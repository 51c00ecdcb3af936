// The domain of coordinates: zero, and magnitudes from 2^-300 to 2^300 (about 4.9e-91 to 2.0e90).
//
// For coordinates in the domain, no exact predicate or construction can overflow or underflow (src/exact/expansion.h
// has the proof). For any other finite coordinate the library throws Error(out_of_domain).
#pragma once

#include <bit>
#include <cstdint>

namespace oblast {

inline constexpr double domain_smallest = 0x1p-300;
inline constexpr double domain_largest = 0x1p+300;

/// True for 0 and for magnitudes in [domain_smallest, domain_largest]; false for NaN and infinity.
constexpr bool in_domain(double coordinate) {
  // The bits without the sign are in the order of the magnitudes.
  constexpr auto magnitude = [](double x) { return std::bit_cast<std::uint64_t>(x) << 1; };
  constexpr std::uint64_t smallest = magnitude(domain_smallest), largest = magnitude(domain_largest);
  return magnitude(coordinate) == 0 || magnitude(coordinate) - smallest <= largest - smallest;
}

}  // namespace oblast
