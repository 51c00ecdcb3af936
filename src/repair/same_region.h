// Whether the rings of a feature are the region that it means. They are if and only if the feature is valid:
//
// A valid region is bounded by simple rings in one way only. Two rings of one polygon share at most one point, and
// rings that touch never close a circle of touches, since that would part the interior; so at each point where rings
// touch it is determined which of them goes on where. Hence the rings of a feature, put in order, are those of its
// resolved region if the feature is valid. And a resolved region is valid (promise G2), so a feature with its rings is,
// too.
//
//   ----t----      The resolved region has a vertex where a vertex of one ring touches an edge of another
//      / \         one (t). It is exactly on the edge, since nothing was rounded there.
#pragma once

#include <oblast/region_set.h>

#include "repair/ordered_ring.h"

namespace oblast::internal::repairing {

/// Whether the polygons of `feature` are those of `resolved`, but for order, directions, starts and repeated points.
/// REQUIRES: `resolved` is canonical. Cost: linear, and sorting the rings.
bool is_same_region(const RegionView& feature, const RegionView& resolved, MoreVertices more);

}  // namespace oblast::internal::repairing
