// Finding all pairs of runs whose boxes meet: a recursive split of the plane.
//
// A cell of the plane with the boxes that touch it is cut at the median of a sample, on the axis that
// leaves fewer boxes on both sides, until about thirty are left; then every pair is tested. A box that
// straddles the cut goes to both halves. The pair (p, q) belongs to the cell that holds the lower left
// corner of the intersection of their boxes, so it is reported once. A cell all of whose boxes are of
// one group (strands.h) is dropped at once: this is what makes later rounds, which look only for what
// the moved pieces can reach, and pairs of large polygons that seldom meet, cheap.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "noding/monotone_runs.h"

namespace oblast::noding {

using RunPair = std::pair<std::uint32_t, std::uint32_t>;

/// Called with pairs of indices into the runs, a batch at a time, from several threads at once.
using PairVisitor = std::function<void(std::span<const RunPair>)>;

/// Every pair of runs whose closed boxes meet, once, except pairs of one group other than any_group.
/// Cost: O((n + k) log n) for k pairs. Memory O(n).
void find_pairs(std::span<const Run> runs, const PairVisitor& visit);

}  // namespace oblast::noding
