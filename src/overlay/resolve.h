// Polygons resolved by themselves: what they mean where their rings cross, overlap or nest.
#pragma once

#include <oblast/region_set.h>

#include "base/call_memory.h"
#include "noding/strands.h"
#include "base/stage_clock.h"

namespace oblast {

/// The even-odd region of a polygon's rings, by the whole pipeline, appended as closed strands that do not meet. True
/// when its rings met somewhere.
bool resolve(const RegionView& rings, noding::Winding winding, noding::Group group, Control& control,
             noding::Strands& strands);

/// The strands with the contours `tangled`, which were assumed to be simple, resolved. REQUIRES: sorted.
noding::Strands resolve_tangled(const noding::Strands& strands, const Array<std::uint32_t>& tangled, Control& control);

}  // namespace oblast
