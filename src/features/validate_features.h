// Refuses layers with bad offsets or bad coordinates, with their place.
#pragma once

#include <oblast/features.h>

#include <cstddef>

namespace oblast::internal {

/// Throws Error: bad_offsets, too_large, not_finite, out_of_domain; of a coordinate with its feature. Cost: linear.
void validate_features(const FeatureView& layer, std::size_t operand);

}  // namespace oblast::internal
