// The canonical form: where contours start, and in which order holes and polygons come.
#pragma once

#include <oblast/region_set.h>

#include <optional>

#include "check/finding.h"

namespace oblast::internal::checking {

/// REQUIRES: nothing else is wrong. Cost: linear, but for contours that touch themselves.
std::optional<Finding> find_bad_order(const RegionView& regions);

}  // namespace oblast::internal::checking
