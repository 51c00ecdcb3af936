// Meetings: where edges meet, and so where they must be cut.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <span>

#include "base/large_pages.h"
#include "base/tuning.h"
#include "noding/monotone_runs.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

/// Edge `edge` is to be cut at `at`, which is none of its ends and lies in its box.
struct EdgeCut {
  std::uint32_t edge;
  float sine;  ///< at most that of the angle to the edge met there; 0 where that is not clear
  Point at;
};

class Clearance;

/// What the first round finds that is to be put right before edges are cut.
struct FirstFindings {
  bool seeks_identical = false, seeks_tangled = false;
  Array<std::uint32_t> tangled;  ///< strands assumed to be simple that are not, sorted; if sought
  bool identical = false;        ///< some two edges have the same two ends; if sought

  bool asks_for_change() const { return identical || !tangled.empty(); }
};

/// How a round of noding settles a crossing.
///
/// The first round puts a new vertex at every crossing, rounded to the nearest double. Where edges run within an
/// ulp of each other, that alone need not end soon: each rounded vertex tilts its edges, the tilted
/// pieces cross their neighbours anew somewhere else, and near 0, where doubles are dense, a crossing can creep
/// towards an axis for thousands of rounds. So from the second round on a crossing that has an end of one edge within
/// `tolerance` of the other is settled there, at a vertex that exists already: no new vertex, so no new tilt. Should
/// even that go on, tolerance and unit of rounding double every round until no new coordinate can appear.
struct Settling {
  double tolerance = 0;  ///< in ulps of the largest coordinate of the two edges; 0: always a new vertex
  int doublings = -1;    ///< new vertices are multiples of that ulp, doubled so often; negative: nearest double

  static Settling of_round(std::uint64_t round) {
    if (round <= tuning::last_nearest_round) return {};
    if (round <= tuning::last_patient_round) return {tuning::settling_ulps, -1};
    const int doublings = static_cast<int>(round - tuning::last_patient_round);
    return {std::ldexp(tuning::settling_ulps, doublings), doublings};
  }
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
