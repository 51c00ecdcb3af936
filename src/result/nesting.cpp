#include "result/nesting.h"

#include <algorithm>
#include <numeric>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "exact/orientation.h"
#include "graph/locate_below.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal {
namespace {

/// The smallest vertex of a ring, and the edge by which the ring arrives there.
struct Smallest {
  BelowQuery arrival;
  bool outer = true;
};

/// A ring that touches itself may visit its smallest vertex more than once. It is a hole if it turns right there once.
Smallest look_at_smallest(const Rings& rings, std::size_t ring) {
  const std::uint32_t begin = rings.begin(ring), end = rings.ends[ring];
  const auto [first, repeated] = smallest_vertex(std::span(rings.points).subspan(begin, end - begin));
  Smallest found;
  const Point p = rings.points[begin + first];
  for (std::uint32_t v = begin + first, past = repeated ? end : v + 1; v < past; ++v) {
    if (rings.points[v] != p) continue;
    const Point& before = rings.points[rings.before(ring, v)];
    const Point& after = rings.points[rings.after(ring, v)];
    found.arrival = {p, before};
    found.outer = exact::orientation(before, p, after) > 0;
    if (!found.outer) break;
  }
  return found;
}

/// True if q arrives at a smaller vertex than r, or at the same vertex from below.
bool lower(const BelowQuery& q, const BelowQuery& r) {
  if (q.p != r.p) return lexicographically_less(q.p, r.p);
  return exact::orientation(q.p, q.q, r.q) > 0;
}

/// Of each walk of holes, the ring that is lowest and leftmost.
Array<std::uint32_t> lowest_holes(const LinkedContours& linked, const Array<std::uint32_t>& polygon_of_walk,
                                  const Array<BelowQuery>& arrivals) {
  Array<std::uint32_t> lowest(linked.walk_count, none);
  for (std::uint32_t r = 0; r < arrivals.size(); ++r) {
    std::uint32_t& first = lowest[linked.walk[r]];
    if (polygon_of_walk[linked.walk[r]] == none && (first == none || lower(arrivals[r], arrivals[first]))) first = r;
  }
  std::erase(lowest, none);
  return lowest;
}

/// The selected chains of the rows of some holes, row by row; those of each are one range.
class ChainsOfRows {
 public:
  /// REQUIRES: `rows` is sorted, without repetition.
  ChainsOfRows(const Selection& selection, std::span<const std::uint32_t> row_of_chain,
               std::span<const std::uint32_t> rows)
      : rows_(rows), ends_(rows.size() + 1, 0) {
    const auto for_each_chain = [&](const auto& visit) {
      for (std::uint32_t c = 0; c < selection.size(); ++c) {
        if (selection[c] == none) continue;
        const std::size_t place = row_of_chain.empty() ? 0 : place_of(row_of_chain[c]);
        if (place < rows_.size()) visit(place, c);
      }
    };
    for_each_chain([&](std::size_t place, std::uint32_t) { ++ends_[place + 1]; });
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    chains_.resize(ends_.back());
    // ends_[i] moves from the beginning of a row to its end.
    for_each_chain([&](std::size_t place, std::uint32_t c) { chains_[ends_[place]++] = c; });
  }

  std::span<const std::uint32_t> chains(std::size_t place) const {
    const std::uint32_t begin = place == 0 ? 0 : ends_[place - 1];
    return std::span(chains_).subspan(begin, ends_[place] - begin);
  }

 private:
  /// rows_.size() where nothing is asked of the row.
  std::size_t place_of(std::uint32_t row) const {
    const auto it = std::lower_bound(rows_.begin(), rows_.end(), row);
    return it != rows_.end() && *it == row ? static_cast<std::size_t>(it - rows_.begin()) : rows_.size();
  }

  std::span<const std::uint32_t> rows_;
  Array<std::uint32_t> ends_, chains_;
};

}  // namespace

Nesting nest(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked, const Rings& rings,
             std::span<const std::uint32_t> row_of_chain) {
  Nesting nesting;
  nesting.polygon.resize(rings.size());
  nesting.outer.resize(rings.size());
  Array<std::uint32_t> polygon_of_walk(linked.walk_count, none);
  Array<BelowQuery> arrivals(rings.size());
  for_ranges(rings.size(), tuning::rings_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const Smallest smallest = look_at_smallest(rings, r);
      nesting.outer[r] = smallest.outer;
      arrivals[r] = smallest.arrival;
    }
  });
  const auto row_of = [&](std::size_t ring) {
    return row_of_chain.empty() ? 0 : row_of_chain[chain_of(linked.contour(ring).front())];
  };
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (!nesting.outer[r]) continue;
    polygon_of_walk[linked.walk[r]] = nesting.polygon_count++;
    if (!row_of_chain.empty()) nesting.row.push_back(row_of(r));
  }

  Array<std::uint32_t> holes = lowest_holes(linked, polygon_of_walk, arrivals);
  parallel_sort(holes.begin(), holes.end(), [&](std::uint32_t r, std::uint32_t s) {
    if (row_of(r) != row_of(s)) return row_of(r) < row_of(s);
    return lexicographically_less(arrivals[r].p, arrivals[s].p);
  });
  Array<std::uint32_t> rows;
  for (const std::uint32_t r : holes)
    if (rows.empty() || rows.back() != row_of(r)) rows.push_back(row_of(r));
  if (!rows.empty()) {
    const ChainsOfRows selected(selection, row_of_chain, rows);
    Array<BelowQuery> queries;
    for (std::size_t i = 0, first = 0; i < rows.size(); ++i) {
      queries.clear();
      for (std::size_t k = first; k < holes.size() && row_of(holes[k]) == rows[i]; ++k)
        queries.push_back(arrivals[holes[k]]);
      const Array<Below> below = locate_below(graph, selected.chains(i), queries);
      for (const Below& b : below)
        polygon_of_walk[linked.walk[holes[first++]]] = polygon_of_walk[linked.walk_of_chain[b.chain]];
    }
  }

  for (std::size_t r = 0; r < rings.size(); ++r) nesting.polygon[r] = polygon_of_walk[linked.walk[r]];
  return nesting;
}

}  // namespace oblast::internal
