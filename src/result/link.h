// Stage 5: links selected chains to contours. At each vertex the angular order decides the turn.
//
// A walk keeps the result on its left. At a node it leaves by the first selected descriptor clockwise from the one by
// which it arrived (the paper's Jump). So it follows one sector of the interior, and never crosses itself or another
// walk:
//
//              | w        it arrives along u, the result is between u and w, and it leaves along w
//         u ---x
//
// This is the `leonov_nikitin` convention. For `ogc`, a walk is then divided where it returns to a node.
#pragma once

#include <oblast/options.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "result/select.h"

namespace oblast::internal {

/// Contours as sequences of descriptors, and the walk from which each was separated.
struct LinkedContours {
  Array<Descriptor> descriptors;
  Array<std::uint32_t> ends;                ///< by contour
  Array<std::uint32_t> walk;                ///< by contour
  LargeArray<std::uint32_t> walk_of_chain;  ///< by chain; none if it is not selected
  std::uint32_t walk_count = 0;

  std::span<const Descriptor> contour(std::size_t c) const {
    const std::uint32_t begin = c == 0 ? 0 : ends[c - 1];
    return std::span(descriptors).subspan(begin, ends[c] - begin);
  }
};

/// Every selected chain is in exactly one contour. Cost: linear in the number of chains and the lengths of the lists.
LinkedContours link(const ChainGraph& graph, const Selection& selection, ContourConvention convention);

}  // namespace oblast::internal
