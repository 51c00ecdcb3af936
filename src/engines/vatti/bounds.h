// Bounds, and the stops of the scan line.
//
//          ______                A chain, cut where it turns back, falls into bounds (Vatti's word), each
//      min<      \___            lexicographically monotone. The scan line stops at every point where
//          \___      \___        bounds start or finish: nodes of the graph, local minima and maxima
//              \_________>max    inside chains, and the seams of closed chains.
//
// Both are laid out in the order in which the scan line comes to them, so that the scan reads memory
// forwards. All that is out of order, and the sorting, is done here, in parallel.
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
  std::uint32_t chain;  ///< which it is a part of
  std::uint32_t top;    ///< stop where it finishes
  Winding change;       ///< winding numbers above it minus those below

  bool is_rightward() const { return first < last; }  ///< runs as its chain does
  std::uint32_t step() const { return is_rightward() ? 1U : ~0U; }
};

struct Stop {
  Point p;
  std::uint32_t bounds_begin = 0;  ///< the first of the bounds that start here; past the last is the next stop's first
};

struct Bounds {
  Array<Bound> bounds;  ///< by the stop where they start; at one stop from below to above
  Array<Stop> stops;    ///< in lexicographic order, and one more behind the last

  std::size_t stop_count() const { return stops.size() - 1; }
  std::span<const Bound> starting_at(std::size_t stop) const {
    return std::span(bounds).subspan(stops[stop].bounds_begin, stops[stop + 1].bounds_begin - stops[stop].bounds_begin);
  }
};

/// The bounds of the given chains. REQUIRES: the chains are live and meet only at their ends.
/// Cost: O(n + (r + s) log (r + s)), n vertices of these chains, r bounds, s stops.
Bounds find_bounds(const ChainGraph& graph, std::span<const std::uint32_t> chains);

}  // namespace oblast::internal::vatti
