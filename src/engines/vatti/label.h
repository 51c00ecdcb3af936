// Stage 3 by the scan line: the engine of the 2013 paper ("Overlays of vector data with a large number of
// simple contours", GraphiCon 2013), after Vatti (Communications of the ACM 35, 1992).
//
// Steps:
//   1. Passive contours skip the scan (passive.h; the paper, 4.2).
//   2. Chains are divided into monotone bounds, and the stops of the scan line are sorted (bounds.h).
//   3. The scan line visits the stops. The active edge list has the bounds that it crosses, from bottom to top, with
//   the
//      winding numbers above each. A bound that starts reads them from its neighbour below (label.cpp, active_edges.h).
//   4. Contours of one operand may overlap (4.3). The paper divides each operand into layers and unites them one by
//   one.
//      Winding numbers make this unnecessary. `layers` (layers.h) is a separate function.
//
// Differences from the paper. Its scan line finds intersections. Ours runs after noding, so bounds are never reordered,
// and every decision is an exact orientation of noded points (a wish at the end of the paper). Ours moves along x and
// orders points lexicographically, so vertical edges are no special case. In the paper, a contour is passive if it has
// no neighbour in the *other* operand; the rule of the operation adds it to the result. Here an operand may overlap
// itself, so a contour is passive if it has no neighbour at all, and gets a label. Stage 4 gives the same rule: A and B
// drops it, A or B keeps it. There is no recursion (4.1), and memory is proportional to the sum of the numbers of
// contours (4.2).
//
// Cost that the paper states: O(n sqrt n), including the search for intersections. Without that search, as here:
// O(n + (r + s) log (r + s)) for n vertices of live chains, r bounds and s stops.
// Measured cost (processor time of this stage alone, one busy core of 2026; in brackets that of leonov_nikitin):
//   overlapping squares   2.2e4, 2.2e5, 2.2e6 chains   195, 238, 318 ns a chain   (285, 524, 898)
//   one tangled contour   8.7e3, 9.2e4, 9.3e5 chains   108, 176, 202 ns a chain    (46, 86, 121)
//   smooth pairs          4.0e4, 4.0e5, 4.0e6 edges    2 ns an edge                (2)
//   disjoint squares      1e4, 1e5, 1e6 edges          11, 10, 10 ns an edge       (90, 99, 116)
//   fires, full size      5.8e6 chains                 256 ns a chain              (431)
#pragma once

#include <vector>

#include "graph/chain_graph.h"

namespace oblast::internal::vatti {

/// For each chain: the winding numbers of A and B on its right side. On its left side they are larger by its change.
/// Only the values of live chains have a meaning. Reads the strands and chains of the graph, not its connectivity
/// lists.
LargeArray<Winding> label(const ChainGraph& graph);

}  // namespace oblast::internal::vatti
