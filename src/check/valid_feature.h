// Whether one feature is a valid polygon or multipolygon. Checks and repairs ask here, so that they never disagree.
#pragma once

#include <oblast/check_features.h>

#include <vector>

#include "check/feature_rings.h"

namespace oblast::internal::checking {

/// Whether the file says which rings are shells and which are holes.
enum class RingRoles { given, none };

/// Adds all faults and notes of a feature by itself, in no particular order. `rings` is scratch memory.
/// Cost: O((n + k) log n), n edges, k pairs of edges that meet. On all cores if the feature is large.
void find_feature_faults(const FeatureSpan& feature, RingRoles roles, FeatureRings& rings,
                         std::vector<FeatureFault>& faults);

/// No faults; notes do not count. Cost: as find_feature_faults().
bool is_valid_feature(const FeatureSpan& feature);

}  // namespace oblast::internal::checking
