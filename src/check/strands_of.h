// The contours as strands, each with its first vertex repeated as its last, and back from a strand's vertex to the
// regions.
//
//   regions   a0 a1 a2 | b0 b1 b2 b3
//   strands   a0 a1 a2 a0 | b0 b1 b2 b3 b0        contour c is strand c, so its vertices are c further on
#pragma once

#include <oblast/region_set.h>

#include <cstdint>

#include "noding/strands.h"

namespace oblast::internal::checking {

/// Without -0.0. All of one winding change, so that the winding number counts how many polygons are at a place.
/// REQUIRES: offsets are right, no contour is empty. Cost: linear.
noding::Strands strands_of(const RegionView& regions);

/// The vertex of the regions that a vertex of the strands is.
inline std::uint32_t vertex_of(const noding::Strands& strands, std::uint32_t index) {
  const auto contour = static_cast<std::uint32_t>(strands.strand_of(index));
  const bool closes = index + 1 == strands.ends[contour];
  return (closes ? strands.begin(contour) : index) - contour;
}

}  // namespace oblast::internal::checking
