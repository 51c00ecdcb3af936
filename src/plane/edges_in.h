// Finds which edges of a path have boxes that meet a given box, for a few edges at a time. All searches for edges use
// this.
#pragma once

#include <oblast/point.h>

#include <cstdint>

#include "plane/box.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace oblast::internal {

/// Bit k: the box of the edge (points[first + k], points[first + k + 1]) meets `box`. Without a branch, because the
/// outcome is hard to predict. REQUIRES: at most 32 edges.
inline std::uint32_t edges_in(const Box& box, const Point* points, std::uint32_t first, std::uint32_t last) {
  std::uint32_t found = 0;
#ifdef __SSE2__
  // x and y at once.
  const __m128d low = _mm_loadu_pd(&box.x0), high = _mm_loadu_pd(&box.x1);
  __m128d p = _mm_loadu_pd(&points[first].x);
  for (std::uint32_t edge = first; edge < last; ++edge) {
    const __m128d q = _mm_loadu_pd(&points[edge + 1].x);
    const __m128d meets = _mm_and_pd(_mm_cmple_pd(_mm_min_pd(p, q), high), _mm_cmple_pd(low, _mm_max_pd(p, q)));
    found |= static_cast<std::uint32_t>(_mm_movemask_pd(meets) == 3) << (edge - first);
    p = q;
  }
#else
  for (std::uint32_t edge = first; edge < last; ++edge)
    found |= static_cast<std::uint32_t>(Box::of(points[edge], points[edge + 1]).meets(box)) << (edge - first);
#endif
  return found;
}

}  // namespace oblast::internal
