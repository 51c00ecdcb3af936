// Features, each with arrays of its own, as one layer.
#pragma once

#include <oblast/features.h>

#include "base/call_memory.h"
#include "base/memory_budget.h"

namespace oblast::internal {

/// What features have become. The arrays of the views must exist.
struct JoinedFeatures {
  FeatureSet features;
  Charge charge;
};

/// Feature f is `parts[f]`, copied bit for bit, with the key (f, no_feature). Throws Error: too_large, memory_limit.
/// Cost: linear, on all cores.
JoinedFeatures join_features(const Array<RegionView>& parts);

}  // namespace oblast::internal
