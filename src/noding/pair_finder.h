// Finding all pairs of runs whose boxes meet: a recursive split of the plane.
//
// A cell of the plane with the boxes that touch it is cut at the median of a sample, on the axis that
// leaves fewer boxes on both sides, until a few hundred are left; those are compared all with all (coarse_boxes.h). A
// box that straddles the cut goes to both halves, so a pair may be found more than once. A cell all of whose boxes are
// of one group (strands.h) is dropped at once: this is what makes later rounds, which look only for what the moved
// pieces can reach, and pairs of large polygons that seldom meet, cheap.
//
// Where too many boxes straddle (long slanting edges, bundles, fans) boxes say too little. There the search
// goes on with single edges, clipped to the cell, and a cut may also follow the line of one of the
// edges: a binary space partition by edges chosen at random, which expects O(n log n + k) pieces
// however the edges lie (Paterson and Yao 1990).
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "base/call_memory.h"
#include "base/tuning.h"
#include "noding/monotone_runs.h"

namespace oblast::internal::noding {

/// Edges [first_p, last_p) against edges [first_q, last_q): runs whose boxes meet.
struct RunPair {
  std::uint32_t first_p, last_p;
  std::uint32_t first_q, last_q;
};

/// A search over no more runs than this visits no pair twice.
inline constexpr std::size_t runs_of_one_cell = tuning::runs_of_one_cell;

/// And over no more than this it stays on the caller's thread: few long edges may still meet in very many places.
inline constexpr std::size_t runs_of_one_thread = runs_of_one_cell;

/// Called a batch at a time, from several threads at once.
using PairVisitor = std::function<void(std::span<const RunPair>)>;

/// What a search is for.
enum class PairGoal {
  meetings,  ///< edges that meet
  boxes,     ///< runs whose boxes meet: never by clipped edges, so slow where many long boxes overlap
};

/// Told of edges with margins near which the search may have missed others, since both touch one edge in a vertex.
/// Called from several threads.
using UnsureEdge = std::function<void(std::uint32_t)>;

/// Visits, for every two edges of different runs that meet, a pair of runs that holds them, once or more often,
/// except where both are of one group other than any_group, or one run goes on from the other (monotone_runs.h). Two
/// edges that meet only in a common end need not be visited where both meet a third one there, which is visited with
/// each. Edge i is (points[i], points[i + 1]). Cost: O((n + k) log n) expected, for k pairs. Memory O(n). The runs are
/// taken over: they are many, and rearranged as the search goes. Edges of runs with margins (Run::margin) are visited,
/// too, if their boxes meet and they come as near to each other as both margins together.
void find_pairs(std::span<const Point> points, LargeArray<Run> runs, const PairVisitor& visit,
                PairGoal goal = PairGoal::meetings, const UnsureEdge& unsure = {});

}  // namespace oblast::internal::noding
