// Bounds, and the stops of the scan line.
//
//          ______                A chain is divided where it turns back. The pieces are bounds (Vatti's
//      min<      \___            word); each is lexicographically monotone. The scan line stops at every
//          \___      \___        point at which bounds start or end: nodes of the graph, local minima and
//              \_________>max    maxima inside chains, and the first points of closed chains.
//
// Bounds and stops are stored in the order in which the scan line reaches them, so the scan reads memory forwards.
// Sorting and random access happen here, in parallel.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal::vatti {

struct Bound {
  Point second;         ///< its second vertex
  std::uint32_t first;  ///< vertex of its smaller end
  std::uint32_t last;   ///< vertex of its larger end
  std::uint32_t chain;  ///< the chain of which it is a part
  std::uint32_t top;    ///< stop at which it ends
  Winding change;       ///< winding numbers above it minus those below

  bool is_rightward() const { return first < last; }  ///< its chain runs to the right there
  std::uint32_t step() const { return is_rightward() ? 1U : ~0U; }
};

struct Stop {
  Point p;
  std::uint32_t bounds_begin =
      0;  ///< the first of the bounds that start here; they end where those of the next stop begin
};

struct Bounds {
  Array<Bound> bounds;  ///< by the stop at which they start; at one stop from bottom to top
  Array<Stop> stops;    ///< in lexicographic order, with one more after the last one

  std::size_t stop_count() const { return stops.size() - 1; }
  std::span<const Bound> starting_at(std::size_t stop) const {
    return std::span(bounds).subspan(stops[stop].bounds_begin, stops[stop + 1].bounds_begin - stops[stop].bounds_begin);
  }
};

/// The bounds of the given chains. REQUIRES: the chains are live and meet only at their ends.
/// Cost: O(n + (r + s) log (r + s)) for n vertices of these chains, r bounds and s stops.
Bounds find_bounds(const ChainGraph& graph, std::span<const std::uint32_t> chains);

}  // namespace oblast::internal::vatti
