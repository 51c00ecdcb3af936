// Noding, settled: edges are cut where they meet until no two of them cross or overlap.
//
// Each round finds all meetings, then makes all cuts, so it is a function of the set of pieces. A cut
// point is rounded, so the next round looks at the pieces just made and at all that they can reach.
// It ends: a piece stays in the box of its edge, and boxes shrink on a finite lattice.
#pragma once

#include <cstdint>
#include <functional>

#include "noding/meetings.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

struct NodingReport {
  explicit NodingReport(bool measured = true) : measures_displacement(measured) {}

  std::uint64_t rounds = 0;
  std::uint64_t cuts = 0;           ///< cuts of edges, over all rounds
  double largest_displacement = 0;  ///< of a cut point from the input edge it lies on, coordinate units; if measured
  bool measures_displacement;
  FirstFindings first;  ///< the caller says whether identical edges are sought; node() whether tangled strands are
};

/// Asked before each round and between pieces of it, from any thread; may throw to cancel.
using Checkpoint = std::function<void()>;

/// Settled strands: any two edges are disjoint, or identical, or share just one end. Every vertex where
/// edges other than its own two end is flagged node_flag; so are the ends of open strands, and the
/// first and last vertex of a closed strand that has a node. `origin` is filled when there were cuts.
/// If report.first asks for a change (some edges are identical, or some strand is tangled), nothing is cut: the caller
/// makes the change and nodes again.
Strands node(Strands strands, NodingReport& report, const Checkpoint& checkpoint = {});

}  // namespace oblast::internal::noding
