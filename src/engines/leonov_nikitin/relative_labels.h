// Labels of everything connected, relative to one of its sectors: rules 2.1 and 2.2 of the paper (label.h), on all
// cores.
//
//   nodes    [ 0 .. 8191 ][ 8192 .. 16383 ] ...      ranges along the curve that nodes are numbered by
//   pieces    a    b   a    c    d  c                what is connected within a range
//                       \__chain___/                 gives c relative to a
//
// Within a range labels are carried breadth first from node to node. Chains from range to range then say how the labels
// of one piece differ from those of another, and a piece takes over those of its component.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal::leonov_nikitin {

struct RelativeLabels {
  LargeArray<Winding> right;            ///< by chain that is no loop: winding numbers on its right side
  LargeArray<std::uint32_t> component;  ///< by node: what it is connected to; none where no chain ends
  std::uint32_t component_count = 0;
};

/// Cost: O(k log k) for k chain ends in lists, nearly all of it linear.
RelativeLabels label_relatively(const ChainGraph& graph);

}  // namespace oblast::internal::leonov_nikitin
