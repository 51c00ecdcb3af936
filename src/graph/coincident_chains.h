// Chains that coincide become one chain, with the sum of the changes; or none where the sum is zero.
//
//     x ======= y     two chains of one edge each, from x to y: the one with the smaller descriptor stands for both
#pragma once

#include "base/call_memory.h"
#include "graph/chain_graph.h"
#include "graph/connectivity_lists.h"

namespace oblast::internal {

/// Step 4. True when there were any.
bool merge_coincident_chains(ChainGraph& graph, const Array<Array<Coincident>>& coincident);

/// Step 5: takes chains that are not live out of the lists.
void drop_dead_chains(ChainGraph& graph);

}  // namespace oblast::internal
