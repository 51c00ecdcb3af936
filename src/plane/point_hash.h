// Hashes points by their bits. REQUIRES: no -0.0.
#pragma once

#include <oblast/point.h>

#include <bit>
#include <cstdint>

namespace oblast::internal {

/// A mixing step as in splitmix64 (Steele, Lea and Flood 2014).
constexpr std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Folds the halves of a 128-bit product. Every bit of x and y affects every bit of the hash.
inline std::uint64_t hash(const Point& p) {
  const auto product = static_cast<unsigned __int128>(std::bit_cast<std::uint64_t>(p.x) ^ 0x9e3779b97f4a7c15ULL) *
                       (std::bit_cast<std::uint64_t>(p.y) ^ 0xd1b54a32d192ed03ULL);
  return static_cast<std::uint64_t>(product >> 64) ^ static_cast<std::uint64_t>(product);
}

}  // namespace oblast::internal
