#include "result/nesting.h"

#include <algorithm>

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

}  // namespace

Nesting nest(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked, const Rings& rings) {
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
  for (std::size_t r = 0; r < rings.size(); ++r)
    if (nesting.outer[r]) polygon_of_walk[linked.walk[r]] = nesting.polygon_count++;

  // For each walk of holes, the ring with the smallest vertex (of several, the lowest).
  Array<std::uint32_t> first_ring(linked.walk_count, none);
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    std::uint32_t& first = first_ring[linked.walk[r]];
    if (polygon_of_walk[linked.walk[r]] == none && (first == none || lower(arrivals[r], arrivals[first]))) first = r;
  }
  std::erase(first_ring, none);
  parallel_sort(first_ring.begin(), first_ring.end(),
                [&](std::uint32_t r, std::uint32_t s) { return lexicographically_less(arrivals[r].p, arrivals[s].p); });
  Array<BelowQuery> queries;
  queries.reserve(first_ring.size());
  for (const std::uint32_t r : first_ring) queries.push_back(arrivals[r]);
  Array<std::uint32_t> selected;
  if (!queries.empty()) {
    for (std::uint32_t c = 0; c < selection.size(); ++c)
      if (selection[c] != none) selected.push_back(c);
  }
  const Array<Below> below = locate_below(graph, selected, queries);
  for (std::size_t i = 0; i < first_ring.size(); ++i)
    polygon_of_walk[linked.walk[first_ring[i]]] = polygon_of_walk[linked.walk_of_chain[below[i].chain]];

  for (std::size_t r = 0; r < rings.size(); ++r) nesting.polygon[r] = polygon_of_walk[linked.walk[r]];
  return nesting;
}

}  // namespace oblast::internal
