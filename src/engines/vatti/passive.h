// Passive contours: those that no other comes near; they need no scan (the paper, 4.2).
//
//    +--+--+--+--+      Contours that meet are one component; its box holds all that it encloses. Boxes of
//    |1 |1 |  |  |      components are counted on an auxiliary raster of about as many cells. A contour that
//    +--+--+--+--+      meets nothing is passive when it is alone in every cell its box touches: nothing
//    |  |2 |1 |1 |      else is inside its box, and it is inside no other's. So its outer side has
//    +--+--+--+--+      winding numbers zero.
//
// The paper's library kept a table of all pairs of contours of the two operands, its authors a table as
// long as their sum; both ask for the other operand only. Counting by corners and summing up (each box four
// updates, one pass over the raster, each contour four reads) is linear in time as well. A contour whose
// cells are shared though its box meets no other is scanned: that costs time, never the answer.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal::vatti {

/// Of the given chains, all that are live, labels the passive contours in `right` and returns the others, in order.
/// Cost: O(n + k log k), n vertices of these chains, k chains.
Array<std::uint32_t> label_passive(const ChainGraph& graph, std::span<const std::uint32_t> chains,
                                   LargeArray<Winding>& right);

}  // namespace oblast::internal::vatti
