// The random numbers of the generators: the same on every machine and with every standard library.
#pragma once

#include <cstdint>

namespace oblast::generators {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// An integer of [0, n). REQUIRES: 0 < n < 2^31. The bias, below 2^-33, does not matter here.
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }

  /// An integer of [low, high].
  int between(int low, int high) { return low + below(high - low + 1); }

  /// A double of [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  double in(double low, double high) { return low + (high - low) * unit(); }

  /// True once in n times.
  bool one_in(int n) { return below(n) == 0; }

 private:
  std::uint64_t state_;
};

}  // namespace oblast::generators
