// The smallest vertex of a ring: where it starts, and what tells its direction.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

namespace oblast::internal {

struct SmallestVertex {
  std::uint32_t vertex;
  bool repeated;  ///< a later one is at the same place
};

/// The first of those vertices than which none is lexicographically smaller. REQUIRES: at least one. Cost: linear, on
/// all cores where they are many.
SmallestVertex smallest_vertex(std::span<const Point> ring);

}  // namespace oblast::internal
