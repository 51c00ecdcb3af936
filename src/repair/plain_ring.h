// Rings as the core wants them: no vertex repeats the one before, and none is -0.0.
#pragma once

#include <oblast/point.h>

#include <span>

#include "base/call_memory.h"

namespace oblast::internal::repairing {

/// The ring without points that repeat the one before; the first one comes after the last. Cost: linear.
inline Array<Point> plain_ring(std::span<const Point> ring) {
  Array<Point> plain;
  plain.reserve(ring.size() + 1);  // room for a closing point
  for (const Point& p : ring)
    if (plain.empty() || plain.back() != p) plain.push_back({p.x + 0.0, p.y + 0.0});
  while (plain.size() > 1 && plain.back() == plain.front()) plain.pop_back();
  return plain;
}

}  // namespace oblast::internal::repairing
