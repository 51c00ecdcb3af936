// What was wrong with a feature, and what its repair changed.
#pragma once

#include <oblast/repair.h>

namespace oblast::internal::repairing {

/// The report, but for the feature's index. REQUIRES: the feature is not valid; it means `resolved`.
/// Cost: a few overlays of the feature.
FeatureRepair describe_repair(const RegionView& feature, const RegionSet& resolved);

}  // namespace oblast::internal::repairing
