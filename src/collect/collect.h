// Stage 1: the contours of both operands to strands of edges.
//
// Degenerate contours are dropped, bad coordinates refused. Under a rule that reads polygons one by one each
// polygon must enter with winding number 1 on its region and 0 elsewhere. Where its edges do not meet, which
// plane/ring_tree.h tells for next to nothing, each ring is turned as its depth in the others asks (its winding change
// is, the points stay where they are); otherwise the polygon is resolved by itself first (noding/resolve.h). The one
// ring of an operand of one polygon is only assumed to be simple where it is not convex, and so is a ring that wanders
// about too much to tell (node_strands.h).
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>

#include "noding/resolve.h"
#include "noding/strands.h"

namespace oblast::internal {

/// `b` may be null. `resolved_polygons` grows by those whose rings were found to meet. Throws Error: not_finite,
/// out_of_domain, too_large, bad_offsets.
noding::Strands collect(const RegionView& a, const RegionView* b, const Options& options, const Resolve& resolve,
                        std::uint64_t& resolved_polygons);

}  // namespace oblast::internal
