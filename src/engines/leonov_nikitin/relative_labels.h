// The labels of each connected component, relative to one of its sectors: rules 2.1 and 2.2 of the paper (label.h), on
// all cores.
//
//   nodes    [ 0 .. 8191 ][ 8192 .. 16383 ] ...      ranges along the curve by which nodes are numbered
//   pieces    a    b   a    c    d  c                the parts of components within a range
//                       \__chain___/                 gives c relative to a
//
// Within a range, labels are carried breadth first from node to node. Then the chains between ranges give the
// difference between the labels of two pieces, and the labels of each piece are made relative to its component.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal::leonov_nikitin {

struct RelativeLabels {
  LargeArray<Winding> right;            ///< by chain, except loops: winding numbers on its right side
  LargeArray<std::uint32_t> component;  ///< by node: its component; none if no chain ends there
  std::uint32_t component_count = 0;
};

/// Cost: O(k log k) for k chain ends in lists, nearly all of it linear.
RelativeLabels label_relatively(const ChainGraph& graph);

}  // namespace oblast::internal::leonov_nikitin
