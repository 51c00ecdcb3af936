// The three settings of the constants in tuning.h. `usual` is for users. With `tiny`, sixty edges reach both sides of
// each constant. With `random`, each constant is drawn between the two, by its name and a seed. The CMake variables
// OBLAST_TUNING and OBLAST_TUNING_SEED choose the setting of a build.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <type_traits>

#ifndef OBLAST_TUNING
#define OBLAST_TUNING usual
#endif
#ifndef OBLAST_TUNING_SEED
#define OBLAST_TUNING_SEED 0
#endif

namespace oblast::internal::tuning {

enum class Setting { usual, tiny, random };

inline constexpr Setting setting = Setting::OBLAST_TUNING;
inline constexpr std::uint64_t seed = OBLAST_TUNING_SEED;

/// The random bits of a constant: FNV-1a of its name, then the finaliser of SplitMix64 with the seed.
constexpr std::uint64_t bits_of(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::uint64_t z = hash + 0x9e3779b97f4a7c15 * (seed + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// A random number from `low` to `high`. First it draws how often `low` is doubled, then a number from there to twice
/// that. So small numbers are about as frequent as large ones. REQUIRES: 0 < low <= high < 2^31.
constexpr std::uint64_t drawn(std::string_view name, std::uint64_t low, std::uint64_t high) {
  const std::uint64_t bits = bits_of(name);
  std::uint64_t doublings = 0;
  while (low << (doublings + 1) <= high) ++doublings;
  const std::uint64_t from = low << bits % (doublings + 1), to = std::min(2 * from, high);
  return from + (bits >> 32) % (to - from + 1);
}

/// The value of a constant in this build. REQUIRES: whole numbers of at least 1, or fractions.
template <class T>
constexpr T choose(std::string_view name, T usual, T tiny) {
  if (setting == Setting::usual) return usual;
  if (setting == Setting::tiny) return tiny;
  if constexpr (std::is_floating_point_v<T>)
    return tiny + (usual - tiny) * static_cast<T>(static_cast<double>(bits_of(name) >> 11) * 0x1p-53);
  else
    return static_cast<T>(drawn(name, static_cast<std::uint64_t>(std::min(usual, tiny)),
                                static_cast<std::uint64_t>(std::max(usual, tiny))));
}

/// The same for constants that must be powers of two. REQUIRES: tiny <= usual, both powers of two.
template <class T>
constexpr T choose_power_of_two(std::string_view name, T usual, T tiny) {
  if (setting == Setting::usual) return usual;
  if (setting == Setting::tiny) return tiny;
  unsigned doublings = 0;
  while (tiny << (doublings + 1) <= usual) ++doublings;
  return tiny << bits_of(name) % (doublings + 1);
}

}  // namespace oblast::internal::tuning
