// Which chain lies directly below a place: the point-in-region queries of contours that meet nothing.
//
//        -------- found --------
//              |
//              p ---- q            the chain next below the edge (p, q), just right of p
//
// A sweep over lexicographically monotone runs of the chains; runs whose range holds no query are left
// out before it begins.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal {

/// An edge from p to q, p lexicographically smaller, of a chain or just touching chains at p.
struct BelowQuery {
  Point p;
  Point q;
};

/// What lies below: a chain, and whether the edge concerned runs to the right (its left side is above)
/// or to the left. chain == none where there is nothing.
struct Below {
  std::uint32_t chain = none;
  bool rightward = false;
};

/// One answer a query. REQUIRES: the chains named by `chains` meet only at their ends.
/// Cost: O(n + (r + q) log(r + q)), n vertices, r runs, q queries.
Array<Below> locate_below(const ChainGraph& graph, std::span<const std::uint32_t> chains,
                          std::span<const BelowQuery> queries);

}  // namespace oblast::internal
