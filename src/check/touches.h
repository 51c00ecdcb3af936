// At nodes, where contours touch: whether they do so as their convention has it.
#pragma once

#include <oblast/options.h>

#include <optional>

#include "check/finding.h"
#include "graph/chain_graph.h"

namespace oblast::internal::checking {

/// A contour that goes through a node twice; under `leonov_nikitin` one that does not hug a sector of the interior:
/// what follows an edge that leaves, counter-clockwise, is not the edge by which the same walk arrived.
std::optional<Finding> find_bad_touch(const ChainGraph& graph, ContourConvention convention);

}  // namespace oblast::internal::checking
