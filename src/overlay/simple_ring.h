// Whether a ring is simple, and which way it runs.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

namespace oblast {

/// What a ring is, judged exactly.
enum class RingShape {
  counter_clockwise,  ///< simple
  clockwise,          ///< simple
  tangled,            ///< its edges meet other than by following one another
};

/// `ring` is closed implicitly, without repeated neighbours, at least three vertices. Cost: O(n) for convex rings,
/// O(n log n) otherwise.
RingShape ring_shape(std::span<const Point> ring);

}  // namespace oblast
