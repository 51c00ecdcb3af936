// Meetings: where edges meet, and so where they must be cut.
#pragma once

#include <cstdint>
#include <functional>

#include "base/large_pages.h"
#include "noding/edge_contact.h"
#include "noding/monotone_runs.h"
#include "noding/settling.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

class Clearance;

/// What the first round finds that is to be put right before edges are cut.
struct FirstFindings {
  bool seeks_identical = false, seeks_tangled = false;
  Array<std::uint32_t> tangled;  ///< strands assumed to be simple that are not, sorted; if sought
  bool identical = false;        ///< some two edges have the same two ends; if sought

  bool asks_for_change() const { return identical || !tangled.empty(); }
};

/// Finds every pair of edges that meet other than by following one another. Where they meet at a vertex of
/// both, the vertices are flagged as nodes; where they meet inside an edge, a cut is returned, and
/// the vertex that lies there, if any, flagged. The cuts come sorted by edge and along it, each once: a
/// function of the set of edges alone.
/// Edges that may meet others anew once they are cut are flagged near_flag: with a `clearance` those that do not keep
/// clear (REQUIRES: Grouping::none), else all that are cut.
/// With `first`, what it lists is looked for; if there is any, no cuts are returned.
/// `checkpoint` is called between batches, from any thread; it may throw to cancel.
LargeArray<EdgeCut> find_meetings(Strands& strands, Grouping grouping, Settling settling,
                                  const std::function<void()>& checkpoint = {}, Clearance* clearance = nullptr,
                                  FirstFindings* first = nullptr);

}  // namespace oblast::internal::noding
