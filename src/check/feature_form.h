// What the two checks of features have in common: the form of their input and the order of their faults.
#pragma once

#include <oblast/check_features.h>

#include <span>
#include <vector>

namespace oblast::internal::checking {

/// Throws Error: bad_offsets, not_finite, out_of_domain, too_large. Cost: linear, on all cores.
void validate_features(const FeatureView& features);

/// A fault for each contour of a list. Throws Error(bad_option) if there is no such contour.
void add_open_contours(const FeatureView& features, std::span<const std::uint32_t> contours,
                       std::vector<FeatureFault>& faults);

/// By feature, contour, vertex, kind, and the same of the other side. Cost: O(n log n), on all cores.
void put_in_order(std::vector<FeatureFault>& faults);

}  // namespace oblast::internal::checking
