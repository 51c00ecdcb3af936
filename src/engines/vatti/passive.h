// Passive contours: contours without others near them. They need no scan (the paper, 4.2).
//
//    +--+--+--+--+      Contours that meet are one component; its box contains everything that it encloses. An
//    |1 |1 |  |  |      auxiliary raster with about as many cells counts the boxes. A contour that meets nothing
//    +--+--+--+--+      is passive if it is alone in every cell that its box touches: nothing else is inside its
//    |  |2 |1 |1 |      box, and it is inside no other box. So the winding numbers on its outer side are zero.
//    +--+--+--+--+
//
// The library in the paper stored a table of all pairs of contours of the two operands; its authors store a table as
// long as the sum. Both consider only the other operand. Counting by corners and summing up takes linear time, too:
// four updates for each box, one pass over the raster, four reads for each contour. A contour whose cells are shared
// although its box meets no other is scanned. That costs time, but does not change the result.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal::vatti {

/// Labels the passive contours among the given chains in `right`, and returns the other chains, in order.
/// REQUIRES: the given chains are all live chains. Cost: O(n + k log k) for k chains with n vertices.
Array<std::uint32_t> label_passive(const ChainGraph& graph, std::span<const std::uint32_t> chains,
                                   LargeArray<Winding>& right);

}  // namespace oblast::internal::vatti
