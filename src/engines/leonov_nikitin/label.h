// The engine of Leonov and Nikitin ("An efficient algorithm for a closed set of Boolean operations on polygonal
// regions in the plane", preprint 46, Novosibirsk 1997), the default: labels carried around vertices and along chains.
//
// The paper's steps and terms, and the files that have them:
//   2.1  intersection vertices               noding/node.h: edges are cut where they meet
//        descriptors, connectivity list L(x)  graph/chain_graph.h, sorted by angle (exactly: graph/angular_order.h)
//   2.2  labels of edges and contours        relative_labels.h: the copying rule 2.1, the marking sectors of rule 2.2;
//                                            label.cpp: contours that meet nothing
//   2.3  Tables 2 and 3                      tables.h; applied by result/select.h
//        Collect and Jump                    result/link.cpp
//   2.4  polygons from contours              result/nesting.h
//
// Differences from the paper:
// - In the paper each operand is a region set, and an edge of one is INSIDE, OUTSIDE, SHARED1 or SHARED2 with respect
// to the
//   other. Here a label is the winding numbers of both operands left and right of a chain. So operands may overlap
//   themselves, and every fill rule works. Coincident edges are one chain with the sum of their changes, so the SHARED
//   labels need no special case.
// - For a contour that meets nothing (not ISECTED), the paper makes a point-in-region query. Here one sweep finds the
// chain
//   directly below each of them (graph/locate_below.h).
// - Jump is computed for all nodes at once.
// - Polygons follow from connected faces, not from the smallest outer contour around a hole.
//
// Cost that the paper states: O(n log* n + k + z log n) for n edges, k intersections and z contours, including the
// search for intersections by Finke and Hinrichs. Without that search, as here: O(n + k + z log z). Measured cost:
// docs/growth.md, with the other engines.
#pragma once

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal::leonov_nikitin {

/// For each chain: the winding numbers of A and B on its right side. On its left side they are larger by its change.
/// Only the values of live chains have a meaning. Cost: O(k + z log z) for z connected components.
LargeArray<Winding> label(const ChainGraph& graph);

}  // namespace oblast::internal::leonov_nikitin
