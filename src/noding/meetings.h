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

/// Finds every pair of edges that meet other than by following one another. Where they meet at a vertex of
/// both, the vertices are flagged as nodes; where they meet inside an edge, a cut is returned, and
/// the vertex that lies there, if any, flagged. The cuts come sorted by edge and along it, each once: a
/// function of the set of edges alone.
/// `checkpoint` is called between batches, from any thread; it may throw to cancel.
std::vector<EdgeCut> find_meetings(Strands& strands, std::span<const Run> runs,
                                   const std::function<void()>& checkpoint = {});

}  // namespace oblast::noding
