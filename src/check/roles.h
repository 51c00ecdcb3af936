// Which contours are outer ones and which are holes.
#pragma once

#include <oblast/region_set.h>

#include <optional>

#include "base/call_memory.h"
#include "check/finding.h"
#include "graph/locate_below.h"

namespace oblast::internal::checking {

/// A contour at its smallest vertex. A hole turns right there: at one of its passes, if it touches itself.
struct Role {
  bool is_hole = false;
  std::uint32_t edge = none;  ///< of a hole: the one that arrives there, by the vertex from which it comes
  BelowQuery arrival = {};    ///< the same edge
};

/// By contour. REQUIRES: edges meet at common ends only. Cost: linear, on all cores.
Array<Role> roles_of(const RegionView& regions);

/// A first contour that is a hole, or a later one that is not.
std::optional<Finding> find_bad_role(const RegionView& regions, const Array<Role>& roles);

}  // namespace oblast::internal::checking
