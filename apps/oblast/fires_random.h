// The random numbers of the generators of fires and roads. Unlike the std distributions, they are the same on every
// machine.
#pragma once

#include <cstdint>

namespace oblast::app {

/// The finalizer of SplitMix64 (Steele, Lea, Flood 2014): a bijection in which every input bit affects every output
/// bit.
constexpr std::uint64_t scatter(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// A hash of a key and a number. For several numbers, use the hash as the next key.
constexpr std::uint64_t mix(std::uint64_t key, std::uint64_t number) {
  return scatter(key + 0x9e3779b97f4a7c15ULL * (number + 1));
}

/// The upper 53 bits as a double in [0, 1).
constexpr double unit_interval(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

/// A stream of SplitMix64 numbers.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() { return scatter(state_ += 0x9e3779b97f4a7c15ULL); }
  constexpr double uniform() { return unit_interval(next()); }
  constexpr double uniform(double from, double to) { return from + (to - from) * uniform(); }
  /// 0 to bound - 1. REQUIRES: bound >= 1. The bias is below bound / 2^32, which does not matter here.
  constexpr std::uint32_t below(std::uint32_t bound) {
    return static_cast<std::uint32_t>(((next() >> 32) * bound) >> 32);
  }
  constexpr bool chance(double probability) { return uniform() < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace oblast::app
