// Stages 1 and 2 alone, for tests of the later ones.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include "graph/chain_graph.h"

namespace oblast::testing {

/// `b` may be null.
internal::ChainGraph graph_of(const RegionView& a, const RegionView* b, const Options& options);

}  // namespace oblast::testing
