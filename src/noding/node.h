// Noding, settled: edges are cut where they meet until no two of them cross or overlap.
//
// Each round finds all meetings, then makes all cuts, so it is a function of the set of pieces. A cut
// point is rounded, so the next round looks at the pieces just made and at all that they can reach.
// It ends: a piece stays in the box of its edge, and boxes shrink on a finite lattice.
#pragma once

#include <cstdint>
#include <functional>

#include "memory/call_memory.h"
#include "noding/strands.h"

namespace oblast::noding {

struct NodingReport {
  explicit NodingReport(bool measured = true) : measures_displacement(measured) {}

  std::uint64_t rounds = 0;
  std::uint64_t cuts = 0;           ///< cuts of edges, over all rounds
  double largest_displacement = 0;  ///< of a cut point from the input edge it lies on, coordinate units; if measured
  bool measures_displacement;
  Array<std::uint32_t> tangled;  ///< strands assumed to be simple that are not
};

/// Asked before each round and between pieces of it, from any thread; may throw to cancel.
using Checkpoint = std::function<void()>;

/// Settled strands: any two edges are disjoint, or identical, or share just one end. Every vertex where
/// edges other than its own two end is flagged node_flag; so are the ends of open strands, and the
/// first and last vertex of a closed strand that has a node. `origin` is filled when there were cuts.
/// Where the report has tangled strands, all strands come back as they were.
Strands node(Strands strands, NodingReport& report, const Checkpoint& checkpoint = {});

}  // namespace oblast::noding
