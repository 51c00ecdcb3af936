// Stage 6, second half: the region set in canonical order (promise G3).
#pragma once

#include <oblast/region_set.h>

#include "base/call_memory.h"
#include "result/nesting.h"

namespace oblast::internal {

/// Each contour from its smallest vertex (of several rotations the one whose sequence is smallest), the
/// outer contour first, holes and polygons in the order of their sequences; of several rows, row by row. Into the
/// arrays of `spare`, whatever is in them. Cost: O(n + z log z).
RegionSet assemble(const Rings& rings, const Nesting& nesting, RegionSet spare = {});

/// Which rows of the result the polygons of several parts belong to.
struct PolygonRows {
  Array<Array<std::uint32_t>> of;  ///< by part and polygon; of a part in order
  Array<std::uint32_t> joined;     ///< by polygon of what the parts were joined to
};

/// One region set of several, each in canonical order, that have no point in common. With `rows` the polygons come row
/// by row, and `rows->joined` is filled. Cost: O(n + p log p), p polygons.
RegionSet join(Array<RegionSet> parts, RegionSet spare = {}, PolygonRows* rows = nullptr);

}  // namespace oblast::internal
