// The domain of coordinates: zero, and magnitudes from 2^-300 to 2^300 (about 4.9e-91 to 2.0e90).
//
// Inside it no exact predicate or construction can overflow or underflow; src/exact/expansion.h
// gives the argument. Outside it the library throws Error(out_of_domain).
#pragma once

namespace oblast {

inline constexpr double domain_smallest = 0x1p-300;
inline constexpr double domain_largest = 0x1p+300;

/// True for 0 and for magnitudes in [domain_smallest, domain_largest]; false for NaN and infinity.
constexpr bool in_domain(double coordinate) {
  const double magnitude = coordinate < 0 ? -coordinate : coordinate;
  return magnitude == 0 || (magnitude >= domain_smallest && magnitude <= domain_largest);
}

}  // namespace oblast
