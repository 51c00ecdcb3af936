// Walks: closed paths with the zone to be made on their right.
//
//   polygon, positive distance    each contour: the outside is on its right
//   polygon, negative distance    each contour reversed: the inside is on its right
//   line, both sides              there and back, with an end at each turn
//   line, one side                there with offsets, and back without
#pragma once

#include <oblast/point.h>

#include <span>

#include "base/call_memory.h"

namespace oblast::internal::buffering {

enum class WalkEdge : unsigned char {
  offset,  ///< an edge of the input: it gets a piece
  lid,     ///< closes a pocket (pockets.h): it gets a piece, too
  bare,    ///< gets no piece
};

enum class Corner : unsigned char {
  join,
  end,   ///< of a line: gets a cap
  bare,  ///< gets no piece
};

/// Vertex i, how the walk turns at it, and the edge from it to the next vertex. No two neighbours are equal.
struct WalkVertex {
  Point at;
  WalkEdge edge = WalkEdge::offset;
  Corner corner = Corner::join;
};

using Walk = Array<WalkVertex>;

/// The path as it is: every vertex is a join, and every edge is offset.
inline Walk plain_walk(std::span<const Point> path) {
  Walk walk;
  for (const Point& p : path) walk.push_back({p});
  return walk;
}

/// A path without vertices that are so near to the one before that their pieces would be lost in rounding: what
/// rounding did to them could open cracks in other pieces. The first and the last point stay. `is_near(p, q)`: q is so
/// near to p.
template <class IsNear>
Array<Point> without_near(std::span<const Point> path, const IsNear& is_near) {
  Array<Point> kept;
  for (const Point& p : path)
    if (kept.empty() || !is_near(kept.back(), p)) kept.push_back(p);
  if (path.empty()) return kept;
  while (kept.size() > 1 && is_near(path.back(), kept.back())) kept.pop_back();
  if (kept.size() > 1 || !is_near(kept.front(), path.back())) kept.push_back(path.back());
  return kept;
}

}  // namespace oblast::internal::buffering
