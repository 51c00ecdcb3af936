// The form of the arrays: offsets, coordinates, vertices of single contours.
#pragma once

#include <oblast/region_set.h>

#include <optional>

#include "check/finding.h"

namespace oblast::internal::checking {

/// A sentence about offsets that are not right. Throws Error(too_large). Cost: linear.
std::optional<const char*> find_bad_offsets(const RegionView& regions);

/// A coordinate that is not in the domain, else a contour of fewer than three vertices or with equal neighbours.
/// REQUIRES: offsets are right. Cost: linear, on all cores.
std::optional<Finding> find_bad_vertex(const RegionView& regions);

}  // namespace oblast::internal::checking
