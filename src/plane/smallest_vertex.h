// The smallest vertex of a ring. A canonical ring starts there, and the turn there determines the direction.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

namespace oblast::internal {

struct SmallestVertex {
  std::uint32_t vertex;
  bool repeated;  ///< a later vertex is at the same point
};

/// The first of the lexicographically smallest vertices. REQUIRES: the ring has a vertex. Cost: linear, on all cores
/// for long rings.
SmallestVertex smallest_vertex(std::span<const Point> ring);

}  // namespace oblast::internal
