// With which other pieces a few pieces share their borders, and along what length.
//
// The pieces are polygons that do not overlap and whose edges are identical or meet at their ends only. So what is
// across an edge from p to q is the piece with the edge from q to p, if there is one.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>

#include "base/call_memory.h"

namespace oblast::internal::repairing {

/// An edge of a piece that another piece has, too.
struct SharedEdge {
  std::uint32_t neighbour;  ///< the other piece
  double length;
};

struct SharedBorders {
  Array<SharedEdge> edges;    ///< of all pieces asked for, in the order of their polygons' vertices
  Array<std::uint32_t> ends;  ///< by piece asked for: past its last one

  std::span<const SharedEdge> of(std::size_t k) const {
    const std::uint32_t begin = k == 0 ? 0 : ends[k - 1];
    return std::span(edges).subspan(begin, ends[k] - begin);
  }
};

/// Of the polygons `asked`, which ascend. Cost: O(n log m) on all cores, n edges of all pieces, m of those asked for.
SharedBorders find_shared_borders(const RegionView& pieces, std::span<const std::uint32_t> asked);

/// A length of border with a feature.
struct OwnedLength {
  std::uint32_t owner;
  double length;
};

/// The owner with the longest border; of several the smallest one. Lengths of one owner are added in their order.
/// no_feature if there are none. Cost: O(m log m).
std::uint32_t longest_owner(Array<OwnedLength> lengths);

}  // namespace oblast::internal::repairing
