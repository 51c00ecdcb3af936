#include "triangulation/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>

#include "base/counting_sort.h"
#include "base/large_pages.h"
#include "base/tuning.h"
#include "plane/curve_order.h"

namespace oblast::internal::triangulation {
namespace {

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t z) {
  z = (z + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

constexpr int most_rounds = tuning::insertion_rounds;

/// The round in which a point is inserted. 0 is the last round.
int round_of(std::uint32_t index) { return std::min(std::countr_zero(mixed(index)) / 3, most_rounds - 1); }

}  // namespace

Array<std::uint32_t> spatial_order(std::span<const Point> points) {
  const LargeArray<Keyed> curve = curve_order(points);
  std::array<std::uint32_t, most_rounds> ends;
  Array<std::uint32_t> order;
  counting_sort(ends, order, [&](const auto& visit) {
    for (const Keyed& k : curve) visit(most_rounds - 1 - round_of(k.index), k.index);
  });
  return order;
}

}  // namespace oblast::internal::triangulation
