// Stage 3 by the scan line: the engine of the 2013 paper ("Overlays of vector data with a large number of
// simple contours", GraphiCon 2013), after Vatti (Communications of the ACM 35, 1992).
//
// Steps, and where they are:
//   1. Passive contours skip the scan (passive.h; the paper, 4.2).
//   2. Chains are split into bounds, which run one way, and the scan line's stops are sorted (bounds.h).
//   3. The scan line passes the stops; the active edge list holds what it crosses, from below to above, with
//      the winding numbers above each. A bound that starts reads them from its neighbour below (label.cpp,
//      active_edges.h).
//   4. Contours of one operand may overlap (4.3). The paper splits each operand into layers and unites them
//      one by one; winding numbers make that needless, and `layers` (layers.h) remains as a component.
//
// Departures from the paper. Its scan line finds intersections, ours runs after noding, so no bound is ever
// reordered and every decision is the exact orientation of noded points: that is its closing wish. Ours moves
// along x and orders lexicographically, so that vertical edges are nothing special. Its passive contours are
// those without a neighbour in the *other* operand, and are added to the result by the operation's rule;
// here an operand may overlap itself, so passive are those without any neighbour at all, and what is
// added is their label, from which the same rule follows at stage 4: A and B drops them, A or B keeps them.
// Nothing recurses (4.1), and memory is in proportion to the sum of the contour counts (4.2).
//
// Cost claimed by the paper: O(n sqrt n), the search for intersections included; with that apart, as here:
// O(n + (r + s) log (r + s)), n vertices of live chains, r bounds, s stops.
// Cost measured (processor time of this stage alone, one busy core of 2026, in brackets that of leonov_nikitin):
//   overlapping squares   2.2e4, 2.2e5, 2.2e6 chains   195, 238, 318 ns a chain   (285, 524, 898)
//   one tangled contour   8.7e3, 9.2e4, 9.3e5 chains   108, 176, 202 ns a chain    (46, 86, 121)
//   smooth pairs          4.0e4, 4.0e5, 4.0e6 edges    2 ns an edge                (2)
//   disjoint squares      1e4, 1e5, 1e6 edges          11, 10, 10 ns an edge       (90, 99, 116)
//   fires, full size      5.8e6 chains                 256 ns a chain              (431)
#pragma once

#include <vector>

#include "graph/chain_graph.h"

namespace oblast::internal::vatti {

/// By chain: the winding numbers of A and B on its right side; the left side is that plus its change.
/// Meaningful for live chains only. Reads the graph's strands and chains alone, not its connectivity lists.
LargeArray<Winding> label(const ChainGraph& graph);

}  // namespace oblast::internal::vatti
