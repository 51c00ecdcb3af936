// Polygons resolved by themselves: what they mean where their rings cross, overlap or nest.
//
// Stages 1 and 2 find such polygons. What they mean is an overlay of its own, so both are handed a function for it.
#pragma once

#include <oblast/region_set.h>

#include <functional>

#include "base/call_memory.h"
#include "base/memory_budget.h"
#include "noding/strands.h"

namespace oblast::internal {

/// The region that the rings of one polygon bound.
struct Resolved {
  Charge charge;  ///< for the regions
  RegionSet regions;
  bool met = false;      ///< its rings met somewhere
  bool touches = false;  ///< some vertex is on the boundary more than once
};

/// The even-odd region of a polygon's rings.
using Resolve = std::function<Resolved(const RegionView& rings)>;

/// Appends the region as closed strands that do not meet. True when the rings met somewhere.
bool append_resolved(const Resolved& resolved, noding::Winding winding, noding::Group group, noding::Strands& strands);

/// The strands with the contours `tangled`, which were assumed to be simple, resolved. REQUIRES: sorted.
noding::Strands resolve_tangled(const noding::Strands& strands, const Array<std::uint32_t>& tangled,
                                const Resolve& resolve);

}  // namespace oblast::internal
