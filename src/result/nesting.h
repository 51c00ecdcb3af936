// Stage 6, first half: finds which contours bound the same region, from the faces of the result.
//
// If the outside is to the west of the smallest vertex of a walk, the walk is the outer contour of a polygon. Any other
// walk is a hole: directly below its smallest vertex p lies a chain of another walk, and nothing lies between the two.
// So both bound the same region. The smallest vertex of that walk is smaller, so in the order of smallest vertices its
// polygon is known already.
#pragma once

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "result/rings.h"

namespace oblast::internal {

struct Nesting {
  Array<std::uint32_t> polygon;  ///< by ring
  Array<std::uint8_t> outer;     ///< by ring: counter-clockwise
  std::uint32_t polygon_count = 0;
  Array<std::uint32_t> row;  ///< by polygon: which row of the result it belongs to; empty where there is but one
};

/// `row_of_chain`, where the result has several rows, is by chain; chains of different rows may be anywhere. Empty: one
/// row. REQUIRES: `rings` are the contours of `linked`, in its order, with all their vertices.
Nesting nest(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked, const Rings& rings,
             std::span<const std::uint32_t> row_of_chain = {});

}  // namespace oblast::internal
