#include "zones/zone_rows.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "base/index.h"
#include "base/large_pages.h"
#include "base/memory_budget.h"
#include "base/parallel.h"

namespace oblast::internal::zoning {
namespace {

/// Writes rows, one after the other. Points are copied at the end, on all cores.
class Writer {
 public:
  explicit Writer(std::uint32_t objects) {
    rows_.feature_ends.reserve(objects);
    rows_.keys.reserve(objects);
    copies_.reserve(objects);
  }

  void add_contour(std::span<const Point> contour) {
    copies_.push_back({contour, points_});
    points_ += contour.size();
    rows_.regions.contour_ends.push_back(checked_index(points_, "vertices of the result", most_vertices));
  }
  void end_polygon() {
    rows_.regions.polygon_ends.push_back(static_cast<std::uint32_t>(rows_.regions.contour_ends.size()));
  }
  void end_row() {
    rows_.keys.push_back({static_cast<std::uint32_t>(rows_.keys.size()), no_feature});
    rows_.feature_ends.push_back(static_cast<std::uint32_t>(rows_.regions.polygon_ends.size()));
  }

  FeatureSet finish() {
    std::vector<Point>& points = rows_.regions.points;
    resize_with_zeros(points, points_);
    for_ranges(copies_.size(), tuning::cells_a_range, [&](std::size_t i, std::size_t end) {
      for (; i < end; ++i) std::copy(copies_[i].from.begin(), copies_[i].from.end(), points.begin() + copies_[i].to);
    });
    return std::move(rows_);
  }

 private:
  struct Copy {
    std::span<const Point> from;
    std::size_t to;
  };

  FeatureSet rows_;
  Array<Copy> copies_;
  std::size_t points_ = 0;
};

/// All that was noded.
FeatureSet rows_of(KeyedResult noded, std::uint32_t objects) {
  FeatureSet rows{std::move(noded.regions), {}, {}};
  rows.feature_ends.reserve(objects);
  rows.keys.reserve(objects);
  std::uint32_t end = 0;
  for (std::uint32_t i = 0, next = 0; i < objects; ++i) {
    if (next < noded.keys.size() && feature_key(noded.keys[next]).a == i) end = noded.feature_ends[next++];
    rows.feature_ends.push_back(end);
    rows.keys.push_back({i, no_feature});
  }
  return rows;
}

}  // namespace

bool has_outline(const KeyedResult& noded, std::uint32_t rest, const WholeCells& cells) {
  Array<OutlineEdge> edges;
  const RegionView regions = noded.regions;
  for (std::size_t row = 0; row < noded.keys.size(); ++row) {
    if (noded.keys[row] != row_key(rest)) continue;
    for (std::uint32_t p = row == 0 ? 0 : noded.feature_ends[row - 1]; p < noded.feature_ends[row]; ++p)
      for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
        const auto contour = regions.contour(c);
        for (std::size_t i = 0; i < contour.size(); ++i)
          edges.push_back({contour[i], contour[i + 1 == contour.size() ? 0 : i + 1]});
      }
  }
  std::sort(edges.begin(), edges.end());
  return edges == cells.outline;
}

FeatureSet rows_of(KeyedResult noded, const WholeCells& cells, std::uint32_t objects) {
  if (cells.empty()) return rows_of(std::move(noded), objects);
  Array<std::uint32_t> cell_of(objects, none);
  for (std::uint32_t i = 0; i < cells.objects.size(); ++i) cell_of[cells.objects[i]] = i;
  const RegionView from = noded.regions;
  const Charge charge(bytes_of_regions(cells.points.size() + from.points.size(), objects, objects));
  Writer writer(objects);
  Steps steps(objects);
  for (std::uint32_t i = 0, next = 0; i < objects; ++i) {
    steps();
    if (const std::uint32_t cell = cell_of[i]; cell != none) {
      const std::uint32_t begin = cell == 0 ? 0 : cells.ends[cell - 1];
      writer.add_contour(std::span(cells.points).subspan(begin, cells.ends[cell] - begin));
      writer.end_polygon();
    } else if (next < noded.keys.size() && feature_key(noded.keys[next]).a == i) {
      for (std::uint32_t p = next == 0 ? 0 : noded.feature_ends[next - 1]; p < noded.feature_ends[next]; ++p) {
        for (std::uint32_t c = from.polygon_begin(p); c < from.polygon_end(p); ++c) writer.add_contour(from.contour(c));
        writer.end_polygon();
      }
      ++next;
    }
    writer.end_row();
  }
  return writer.finish();
}

}  // namespace oblast::internal::zoning
