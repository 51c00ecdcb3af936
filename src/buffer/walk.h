// Walks: closed paths with the zone to be made on their right.
//
//   polygon, positive distance    each contour: the outside is on its right
//   polygon, negative distance    each contour reversed: the inside is on its right
//   line, both sides              there and back, with an end at each turn
//   line, one side                there with offsets, and back without
#pragma once

#include <oblast/point.h>

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

}  // namespace oblast::internal::buffering
