// Pockets that are too narrow to matter are closed by lids, so that many short edges need few pieces.
//
//        ___  lid  ___              An outline at distance d from both ends of a lid of length w is at most
//       |   |     |   |             sqrt(d^2 + w^2 / 4) from the input. What the chain does in the pocket
//    ---p   |__^__|   q---          changes nothing more: it is nearer than w to the lid's ends.
//            chain
//
// A chain of neighbouring vertices is replaced by the side of its hull that is on its right. For a simple chain between
// two corners of its hull, the lids and the chain enclose the pockets with winding number 1, so the walk still winds
// around everything it did, and around the pockets. Of a line, which may cross itself, both sides of the hull are
// taken: together they wind around the hull once.
//
// Ends of lids are vertices of the input. Which ones depends on the path alone: on its vertices from its first one on.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "buffer/walk.h"

namespace oblast::internal::buffering {

/// A path, with the pockets on its right closed, and with those on its left closed. Both begin and end as the path
/// does.
struct ClosedPath {
  Walk right, left;           ///< the last vertex has no edge
  std::uint64_t pockets = 0;  ///< lids on both sides
};

/// Closes what is not wider than `widest`. `both`: of the left side, too; else `left` stays empty. REQUIRES: no two
/// neighbours of the path are equal; if not `both`, no part of the path between two equal points is shorter than half
/// of it.
ClosedPath close_pockets(std::span<const Point> path, double widest, bool both);

}  // namespace oblast::internal::buffering
