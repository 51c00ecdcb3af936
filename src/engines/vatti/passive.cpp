// Finds passive contours with a raster of counts.
#include "engines/vatti/passive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/call.h"
#include "base/call_memory.h"
#include "base/disjoint_sets.h"
#include "base/tuning.h"
#include "exact/orientation.h"

namespace oblast::internal::vatti {
namespace {

struct Extent {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(const Point& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void add(const Extent& e) {
    add(e.low);
    add(e.high);
  }
  bool is_empty() const { return low.x > high.x; }
};

/// Cells of an extent: columns [x0, x1), rows [y0, y1).
struct Cells {
  std::uint32_t x0, y0, x1, y1;

  std::uint64_t count() const { return std::uint64_t{x1 - x0} * (y1 - y0); }
};

/// The number of extents that touch each cell. After `sum_up`: the number in all cells of a rectangle together.
class CountRaster {
 public:
  CountRaster(const Extent& whole, std::size_t cells)
      : whole_(whole),
        side_(static_cast<std::uint32_t>(
            std::clamp(std::sqrt(double(cells)), 1.0, double(tuning::largest_raster_side)))) {
    const double width = whole.high.x - whole.low.x, height = whole.high.y - whole.low.y;
    scale_x_ = width > 0 ? side_ / width : 0;
    scale_y_ = height > 0 ? side_ / height : 0;
    counts_.assign(std::size_t{side_ + 1} * (side_ + 1), 0);
  }

  /// The cells of an extent. Rounding is monotone, so extents that meet have a cell in common.
  Cells cells(const Extent& e) const {
    return {cell((e.low.x - whole_.low.x) * scale_x_), cell((e.low.y - whole_.low.y) * scale_y_),
            cell((e.high.x - whole_.low.x) * scale_x_) + 1, cell((e.high.y - whole_.low.y) * scale_y_) + 1};
  }

  void add(const Cells& c) {
    ++at(c.x0, c.y0);
    --at(c.x1, c.y0);
    --at(c.x0, c.y1);
    ++at(c.x1, c.y1);
  }

  /// Converts the corners to counts, and the counts to sums over all cells before.
  void sum_up() {
    sum_corners();
    sum_corners();
  }

  /// True if only one extent touches these cells. REQUIRES: sum_up was called; some extent has exactly these cells.
  bool is_alone(const Cells& c) const {
    const std::int64_t sum = before(c.x1, c.y1) - before(c.x0, c.y1) - before(c.x1, c.y0) + before(c.x0, c.y0);
    return static_cast<std::uint64_t>(sum) == c.count();
  }

 private:
  std::uint32_t cell(double position) const { return std::min(static_cast<std::uint32_t>(position), side_ - 1); }
  std::int64_t& at(std::uint32_t x, std::uint32_t y) { return counts_[std::size_t{y} * (side_ + 1) + x]; }
  /// The sum over the cells left of column x and below row y.
  std::int64_t before(std::uint32_t x, std::uint32_t y) const {
    return x == 0 || y == 0 ? 0 : counts_[std::size_t{y - 1} * (side_ + 1) + (x - 1)];
  }

  void sum_corners() {
    const std::size_t width = side_ + 1;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      const bool has_left = i % width != 0, has_lower = i >= width;
      if (has_left) counts_[i] += counts_[i - 1];
      if (has_lower) counts_[i] += counts_[i - width];
      if (has_left && has_lower) counts_[i] -= counts_[i - width - 1];
    }
  }

  Extent whole_;
  std::uint32_t side_;
  double scale_x_, scale_y_;
  Array<std::int64_t> counts_;
};

/// Decided by the turn at the smallest vertex. A noded loop has no straight turn there.
bool is_counter_clockwise(const ChainGraph& graph, const Chain& loop) {
  std::uint32_t smallest = loop.first;
  for (std::uint32_t v = loop.first + 1; v < loop.last; ++v)
    if (lexicographically_less(graph.point(v), graph.point(smallest))) smallest = v;
  const Point& before = graph.point(smallest == loop.first ? loop.last - 1 : smallest - 1);
  return exact::orientation(before, graph.point(smallest), graph.point(smallest + 1)) > 0;
}

}  // namespace

Array<std::uint32_t> label_passive(const ChainGraph& graph, std::span<const std::uint32_t> chains,
                                   LargeArray<Winding>& right) {
  // Extents by component. A closed chain without nodes is a component; its number follows those of the nodes.
  DisjointSets components(graph.node_count());
  for (const std::uint32_t c : chains)
    if (!graph.chains[c].is_loop()) components.unite(graph.chains[c].from, graph.chains[c].to);
  Array<Extent> extents(graph.node_count());
  Extent whole;
  Steps steps(chains.size());
  for (const std::uint32_t c : chains) {
    steps();
    const Chain& chain = graph.chains[c];
    if (chain.is_loop()) extents.emplace_back();
    Extent& extent = chain.is_loop() ? extents.back() : extents[components.find(chain.from)];
    for (std::uint32_t v = chain.first; v <= chain.last; ++v) extent.add(graph.point(v));
    whole.add(extent);
  }

  CountRaster raster(whole, chains.size());
  for (const Extent& e : extents)
    if (!e.is_empty()) raster.add(raster.cells(e));
  raster.sum_up();

  Array<std::uint32_t> active;
  auto extent_of_loop = extents.begin() + static_cast<std::ptrdiff_t>(graph.node_count());
  for (const std::uint32_t c : chains) {
    steps();
    const Chain& chain = graph.chains[c];
    const bool passive = chain.is_loop() && raster.is_alone(raster.cells(*extent_of_loop++));
    if (!passive)
      active.push_back(c);
    else
      right[c] = is_counter_clockwise(graph, chain) ? Winding{} : -chain.change;
  }
  return active;
}

}  // namespace oblast::internal::vatti
