// What the contours bound: which side of them is inside, and what belongs together.
//
//     nobody | nobody       An edge that leaves the node has the interior of its polygon on its left, so after it,
//        in \|/ out         counter-clockwise; one that arrives has it before it. All winding numbers are 0 or 1, so
//       -----*-----         around a node edges that leave and edges that arrive take turns. The sector between one
//       that
//          P | P            leaves and the next, which arrives, is of one face, so both are of one polygon.
#pragma once

#include <oblast/region_set.h>

#include <optional>

#include "check/finding.h"
#include "check/roles.h"
#include "graph/chain_graph.h"

namespace oblast::internal::checking {

/// A chain with something else than nothing on its right and one polygon on its left. Cost: of the engine that labels.
std::optional<Finding> find_wrong_side(const ChainGraph& graph);

/// Contours of two polygons that bound one face; then a polygon with several faces.
/// REQUIRES: no bad meeting, touch, side or role. Cost: O(n + c log c), c chains.
std::optional<Finding> find_bad_face(const RegionView& regions, const ChainGraph& graph, const Array<Role>& roles);

}  // namespace oblast::internal::checking
