#include "io/row_neighbours.h"

#include <algorithm>
#include <tuple>

namespace oblast::io {

namespace {

struct Side {
  Point low, high;
  std::uint32_t row;

  auto key() const { return std::tuple(low.x, low.y, high.x, high.y, row); }
  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sides_of(const FeatureView& rows) {
  std::vector<Side> sides;
  sides.reserve(rows.regions.points.size());
  for (std::uint32_t row = 0; row < rows.feature_count(); ++row) {
    for (std::uint32_t p = rows.feature_begin(row); p < rows.feature_end(row); ++p) {
      for (const std::span<const Point> contour : rows.regions.polygon(p).contours()) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
          const Point a = contour[i], b = contour[i + 1 == contour.size() ? 0 : i + 1];
          const bool ascends = std::tuple(a.x, a.y) < std::tuple(b.x, b.y);
          sides.push_back({ascends ? a : b, ascends ? b : a, row});
        }
      }
    }
  }
  return sides;
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours_of(const FeatureView& rows) {
  std::vector<Side> sides = sides_of(rows);
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) { return s.key() < t.key(); });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].same_edge(sides[i - 1]) && sides[i].row != sides[i - 1].row)
      pairs.emplace_back(sides[i - 1].row, sides[i].row);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace oblast::io
