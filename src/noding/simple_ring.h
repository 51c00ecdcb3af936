// Whether a ring is simple, and which way it runs.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "plane/ring_tree.h"

namespace oblast::internal {

/// What a ring is, judged exactly.
enum class RingShape {
  counter_clockwise,  ///< simple
  clockwise,          ///< simple
  tangled,            ///< its edges meet other than by following one another
};

/// `ring` is closed implicitly, without repeated neighbours, at least three vertices. Cost: O(n) for convex rings,
/// O(n log n) otherwise.
RingShape ring_shape(std::span<const Point> ring);

/// Whether edges of a closed ring, whose first vertex is repeated as its last, meet other than by following one
/// another. `tree` is room to work in. Cost: O(n) for most rings, O(n log n) for all.
bool is_tangled(std::span<const Point> closed_ring, RingTree& tree);

/// The common sign of all turns when the ring is convex (straight vertices allowed); 0 when it is not, or has repeated
/// neighbours. `ring` is closed implicitly, at least three vertices. Cost: linear, and for most rings that are not
/// convex a few vertices.
int convex_turn(std::span<const Point> ring);

/// The turn at the smallest vertex, which gives the direction of a simple ring.
int turn_at_smallest(std::span<const Point> ring);

}  // namespace oblast::internal
