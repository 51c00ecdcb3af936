// Which ring of a feature lies in which, and what follows from it.
#pragma once

#include <cstdint>
#include <vector>

#include "base/call_memory.h"
#include "check/feature_meetings.h"
#include "check/feature_rings.h"

namespace oblast::internal::checking {

struct RingNesting {
  Array<std::uint32_t> parent;  ///< by ring: the innermost ring around it; FeaturePlace::none: there is none
  Array<std::uint8_t> is_ccw;   ///< by ring; of one that crosses itself, at its smallest vertex
};

/// Of rings that are not broken; the others have no parent and are nobody's. Rings may touch themselves and each other.
/// A sweep from left to right: a ring lies directly above what is below the lower of its edges at its first vertex.
/// Cost: O(n log n).
RingNesting nest_rings(const FeatureRings& rings);

/// Gives each ring a role and a part by how deep it lies, and puts the rings of a part together, its shell first. No
/// ring is broken then: meetings must be looked for again.
void give_roles(FeatureRings& rings, const RingNesting& nesting);

/// Adds holes outside their shell, holes in holes, parts in parts, cut interiors and notes on orientation.
/// Cost: O(t log t + r d), t touches, r rings, d the depth of their nesting.
void find_bad_nesting(const FeatureRings& rings, const RingNesting& nesting, Array<RingTouch> touches,
                      std::vector<FeatureFault>& faults);

}  // namespace oblast::internal::checking
