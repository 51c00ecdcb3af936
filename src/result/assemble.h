// Stage 6, second half: the region set in canonical order (promise G3).
#pragma once

#include <oblast/region_set.h>

#include "base/call_memory.h"
#include "result/nesting.h"

namespace oblast::internal {

/// The region set. Each contour starts at its smallest vertex; if several rotations do, the one with the smallest
/// sequence is taken. The outer contour of a polygon is first. Holes and polygons are sorted by their sequences. Reuses
/// the arrays of `spare`, whatever their contents. Cost: O(n + z log z).
RegionSet assemble(const Rings& rings, const Nesting& nesting, RegionSet spare = {});

/// Joins region sets that are in canonical order and have no point in common. Cost: O(n + p log p) for p polygons.
RegionSet join(Array<RegionSet> parts, RegionSet spare = {});

}  // namespace oblast::internal
