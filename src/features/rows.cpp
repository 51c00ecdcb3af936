#include "features/rows.h"

#include <algorithm>

#include "base/index.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "result/assemble.h"
#include "result/link.h"
#include "result/nesting.h"

namespace oblast::internal {
namespace {

/// A border of a row. The row is on its left, or on its right where it is taken backward.
struct RowBorder {
  RowKey key;
  std::uint32_t path;
  bool backward;
};

Array<RowBorder> find_row_borders(const Borders& borders, const LabelSets& sets, const KeyRule& rule) {
  const std::size_t count = borders.paths.size();
  Array<Array<RowBorder>> found(range_count(count, tuning::bordered_paths_a_task));
  for_numbered_ranges(count, tuning::bordered_paths_a_task, [&](std::size_t i, std::size_t begin, std::size_t end) {
    for (auto path = static_cast<std::uint32_t>(begin); path < end; ++path) {
      const FaceLabel left = borders.left[path], right = borders.right[path];
      rule.for_each_only_in(sets, left, right, [&](RowKey key) { found[i].push_back({key, path, false}); });
      rule.for_each_only_in(sets, right, left, [&](RowKey key) { found[i].push_back({key, path, true}); });
    }
  });
  std::size_t size = 0;
  for (const auto& range : found) size += range.size();
  check_count(size, "borders of rows", most_chains);
  Array<RowBorder> all;
  all.reserve(size);
  for (auto& range : found) {
    all.insert(all.end(), range.begin(), range.end());
    range = {};
  }
  parallel_sort(all.begin(), all.end(), [](const RowBorder& p, const RowBorder& q) {
    return p.key != q.key ? p.key < q.key : p.path < q.path;
  });
  return all;
}

/// The graphs of a range of rows, side by side in one, and which borders of it are selected: all.
class RowGraphs {
 public:
  /// `first_row` is the row of the first border.
  RowGraphs(const Borders& borders, std::span<const RowBorder> row_borders, std::uint32_t first_row)
      : borders_(borders) {
    std::size_t points = 0;
    std::uint32_t open = 0;
    for (const RowBorder& border : row_borders) {
      points += borders.paths.ends[border.path] - borders.paths.begin(border.path) + 1;
      open += borders.paths.is_open(border.path);
    }
    checked_index(points, "vertices of rows");
    graph.strands.points.reserve(points);
    graph.first_loop = open;
    graph.chains.resize(row_borders.size());
    selection.resize(row_borders.size());
    row_of_chain.resize(row_borders.size());
    ends_.reserve(2 * open);
    std::uint32_t row = first_row, next_open = 0, next_loop = open;
    for (std::size_t i = 0; i < row_borders.size(); ++i) {
      if (i > 0 && row_borders[i].key != row_borders[i - 1].key) ++row;
      const bool is_open = borders.paths.is_open(row_borders[i].path);
      add(row_borders[i], row, is_open ? next_open++ : next_loop++);
    }
    add_nodes();
  }

  ChainGraph graph;
  Selection selection;
  Array<std::uint32_t> row_of_chain;

 private:
  /// An end of a border in a row.
  struct End {
    std::uint32_t row, place, node;
    Descriptor leaving;
  };

  void add(const RowBorder& border, std::uint32_t row, std::uint32_t chain) {
    auto& points = graph.strands.points;
    const Rings& paths = borders_.paths;
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), paths.points.begin() + paths.begin(border.path),
                  paths.points.begin() + paths.ends[border.path]);
    if (!paths.is_open(border.path)) points.push_back(Point(points[first]));
    graph.chains[chain] = {first, static_cast<std::uint32_t>(points.size() - 1), none, none, none, chain, {1, 0}};
    selection[chain] = border.backward ? opposite(forward(chain)) : forward(chain);
    row_of_chain[chain] = row;
    if (!paths.is_open(border.path)) return;
    const BorderEnd &from = borders_.from[border.path], &to = borders_.to[border.path];
    ends_.push_back({row, from.place, from.node, forward(chain)});
    ends_.push_back({row, to.place, to.node, opposite(forward(chain))});
  }

  void add_nodes() {
    std::sort(ends_.begin(), ends_.end(),
              [](const End& p, const End& q) { return p.row != q.row ? p.row < q.row : p.place < q.place; });
    graph.lists.reserve(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const Descriptor d = ends_[i].leaving;
      if (i == 0 || ends_[i].row != ends_[i - 1].row || ends_[i].node != ends_[i - 1].node) {
        graph.node_vertex.push_back(graph.start_vertex(d));
        graph.list_ends.push_back(0);
      }
      Chain& chain = graph.chains[chain_of(d)];
      (is_backward(d) ? chain.to : chain.from) = static_cast<std::uint32_t>(graph.node_vertex.size() - 1);
      graph.lists.push_back(d);
      graph.list_ends.back() = static_cast<std::uint32_t>(graph.lists.size());
    }
  }

  const Borders& borders_;
  Array<End> ends_;
};

/// One range of rows.
void build_range(const RowGraphs& rows, ContourConvention convention, std::size_t range, BatchRows& result) {
  const LinkedContours linked = link(rows.graph, rows.selection, convention);
  NodeKinds kinds;  // traces are gone, and nobody asks about touches
  kinds.flags.resize(rows.graph.node_count(), 0);
  const Rings rings = contours_to_rings(rows.graph, kinds, linked);
  Nesting nesting = nest(rows.graph, rows.selection, linked, rings, rows.row_of_chain);
  Charge charge(bytes_of_regions(rings.points.size(), rings.size(), nesting.polygon_count));
  result.regions[range] = assemble(rings, nesting);
  result.charges[range] = std::move(charge);
  std::sort(nesting.row.begin(), nesting.row.end());
  result.rows[range] = std::move(nesting.row);
}

}  // namespace

BatchRows build_rows(const Borders& borders, const LabelSets& sets, const KeyRule& rule, ContourConvention contours) {
  const Array<RowBorder> all = find_row_borders(borders, sets, rule);
  BatchRows result;
  struct Range {
    std::size_t first;  ///< border
    std::uint32_t first_row;
  };
  Array<Range> ranges;
  std::size_t vertices = tuning::row_vertices_a_range;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_new = i == 0 || all[i].key != all[i - 1].key;
    if (is_new && vertices >= tuning::row_vertices_a_range) {
      ranges.push_back({i, static_cast<std::uint32_t>(result.keys.size())});
      vertices = 0;
    }
    if (is_new) result.keys.push_back(all[i].key);
    vertices += borders.paths.ends[all[i].path] - borders.paths.begin(all[i].path);
  }
  result.regions.resize(ranges.size());
  result.rows.resize(ranges.size());
  result.charges.resize(ranges.size());
  for_ranges(ranges.size(), 1, [&](std::size_t i, std::size_t past) {
    for (; i < past; ++i) {
      const std::size_t first = ranges[i].first, end = i + 1 < ranges.size() ? ranges[i + 1].first : all.size();
      // A thread that waits within a range must not begin another one there.
      isolated([&] {
        build_range(RowGraphs(borders, std::span(all).subspan(first, end - first), ranges[i].first_row), contours, i,
                    result);
      });
    }
  });
  return result;
}

}  // namespace oblast::internal
