// Stage 1: the contours of both operands to strands of edges.
//
// Degenerate contours are dropped, bad coordinates refused. Under a rule that reads polygons one by one each
// polygon must enter with winding number 1 on its region and 0 elsewhere: a polygon of one ring is turned (its
// winding change is, the points stay where they are), and where it is not convex only assumed to be simple
// (node_strands.h); one of several rings is resolved by itself first, by the whole pipeline under even_odd.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include "noding/strands.h"
#include "overlay/control.h"

namespace oblast {

/// `b` may be null. Throws Error: not_finite, out_of_domain, too_large, bad_offsets.
noding::Strands collect(const RegionView& a, const RegionView* b, const Options& options, Control& control,
                        Statistics& statistics);

}  // namespace oblast
