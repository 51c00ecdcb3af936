// Where edges of one feature meet, other than one after the other in a ring.
#pragma once

#include <cstdint>
#include <vector>

#include "base/call_memory.h"
#include "check/feature_rings.h"

namespace oblast::internal::checking {

/// Two rings of one part have a point in common and do not cross there: allowed.
struct RingTouch {
  Point point;
  std::uint32_t ring, index;              ///< by index of FeatureRings::points
  std::uint32_t other_ring, other_index;  ///< the vertex, or the edge that begins there
};

/// Adds the faults of edges that cross, touch or run along each other, marks rings as broken, and returns the touches.
/// A line along which two rings run for several edges is one fault. Cost: O((n + k) log n), k pairs of edges that meet;
/// linear for most features whose edges do not meet. On all cores if the feature is large.
Array<RingTouch> find_feature_meetings(FeatureRings& rings, std::vector<FeatureFault>& faults);

}  // namespace oblast::internal::checking
