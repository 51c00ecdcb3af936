// Meetings: where edges meet, and so where they must be cut.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "noding/monotone_runs.h"
#include "noding/strands.h"

namespace oblast::noding {

/// Edge `edge` is to be cut at `at`, which is none of its ends and lies in its box.
struct EdgeCut {
  std::uint32_t edge;
  Point at;
};

/// How new points are rounded in a round of noding.
///
/// The first three rounds round to the nearest double. That alone need not end soon: near 0 doubles are so dense
/// that a crossing can creep towards an axis for thousands of rounds, each bending an edge by an ulp of the
/// other coordinate. So from the fourth round on a new point is rounded further, to multiples of a
/// unit, and kept in the boxes of both edges: the unit is the ulp of the largest coordinate of the two
/// edges, doubled every round. Once it exceeds the boxes no new coordinate appears at all.
struct PointRounding {
  int doublings = -1;  ///< of the ulp; negative: nearest double

  static PointRounding of_round(std::uint64_t round) {
    constexpr std::uint64_t last_nearest = 3;
    return {round <= last_nearest ? -1 : static_cast<int>(round - last_nearest - 1)};
  }
};

/// Finds every pair of edges that meet other than by following one another. Where they meet at a vertex of
/// both, the vertices are flagged as nodes; where they meet inside an edge, a cut is returned, and
/// the vertex that lies there, if any, flagged. The cuts come sorted by edge and along it, each once: a
/// function of the set of edges alone.
/// `checkpoint` is called between batches, from any thread; it may throw to cancel.
std::vector<EdgeCut> find_meetings(Strands& strands, std::span<const Run> runs, PointRounding rounding,
                                   const std::function<void()>& checkpoint = {});

}  // namespace oblast::noding
