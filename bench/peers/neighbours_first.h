// The union of many polygons for peers that unite only two. Parts are sorted along a Z curve and united in pairs, then
// the results are united in pairs, and so on.
#pragma once

#include <oblast/point.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace oblast::bench {

/// Interleaves the bits of two 16-bit numbers.
inline std::uint32_t z_order(std::uint32_t x, std::uint32_t y) {
  std::uint32_t z = 0;
  for (unsigned bit = 0; bit < 16; ++bit) z |= (x >> bit & 1) << (2 * bit) | (y >> bit & 1) << (2 * bit + 1);
  return z;
}

template <class Set, class Unite>
Set unite_neighbours_first(std::vector<std::pair<Point, Set>> parts, Unite unite) {
  if (parts.empty()) return {};
  Point low = parts[0].first, high = low;
  for (const auto& [p, part] : parts) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto cell = [](double value, double from, double to) {
    return to > from ? static_cast<std::uint32_t>((value - from) / (to - from) * 65535) : 0;
  };
  std::vector<std::pair<std::uint32_t, Set>> sorted;
  for (auto& [p, part] : parts) {
    sorted.emplace_back(z_order(cell(p.x, low.x, high.x), cell(p.y, low.y, high.y)), std::move(part));
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  while (sorted.size() > 1) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sorted.size(); i += 2, ++kept) {
      Set united = i + 1 < sorted.size() ? unite(sorted[i].second, sorted[i + 1].second) : std::move(sorted[i].second);
      sorted[kept].second = std::move(united);
    }
    sorted.resize(kept);
  }
  return std::move(sorted[0].second);
}

}  // namespace oblast::bench
