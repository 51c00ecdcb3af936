// The chains, and at each node the list of those that end there, counter-clockwise.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "graph/chain_graph.h"
#include "graph/stops.h"

namespace oblast::internal {

/// Descriptors [first, last) in `lists` of one direction from a node.
struct Coincident {
  std::uint32_t first, last;
};

/// Step 3: the chains and the connectivity lists L(x), each sorted by angle. Returns what coincides, by range of nodes.
Array<Array<Coincident>> build_connectivity_lists(ChainGraph& graph, const Stops& stops);

}  // namespace oblast::internal
