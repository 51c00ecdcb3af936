// Bounds, and the stops of the scan line.
//
//          ______                A chain, cut where it turns back, falls into bounds (Vatti's word), each
//      min<      \___            lexicographically monotone. The scan line stops at every point where
//          \___      \___        bounds start or finish: nodes of the graph, local minima and maxima
//              \_________>max    inside chains, and the seams of closed chains.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "overlay/chain_graph.h"

namespace oblast::vatti {

struct Bound {
  std::uint32_t first;  ///< vertex of its smaller end
  std::uint32_t last;   ///< vertex of its larger end
  std::uint32_t chain;
  std::uint32_t top;         ///< stop where it finishes
  std::uint32_t next_start;  ///< another bound that starts at the same stop, or none

  bool is_rightward() const { return first < last; }  ///< runs as its chain does
  std::uint32_t step() const { return is_rightward() ? 1U : ~0U; }
};

/// What happens at one place.
struct Stop {
  std::uint32_t start = none;   ///< head of the list of the bounds that start here
  std::uint32_t finish = none;  ///< one of the bounds that finish here; the others are its neighbours by then
};

/// A stop with its place, for sorting.
struct PlacedStop {
  Point p;
  std::uint32_t stop;
};

struct Bounds {
  std::vector<Bound> bounds;
  std::vector<Stop> stops;
  std::vector<PlacedStop> order;  ///< the stops where something happens, lexicographically sorted
};

/// The bounds of the given chains. REQUIRES: the chains are live and meet only at their ends.
/// Cost: O(n + s log s), n vertices of these chains, s stops.
Bounds find_bounds(const ChainGraph& graph, std::span<const std::uint32_t> chains);

}  // namespace oblast::vatti
