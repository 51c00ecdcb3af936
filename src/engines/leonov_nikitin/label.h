// The engine of Leonov and Nikitin ("An efficient algorithm for a closed set of Boolean operations on polygonal
// regions in the plane", preprint 46, Novosibirsk 1997), the default: labels carried around vertices and along chains.
//
// The paper's steps and terms, and where they are:
//   2.1  intersection vertices               noding/node.h: edges are cut where they meet
//        descriptors, connectivity list L(x)  graph/chain_graph.h, sorted by angle (exactly: graph/angular_order.h)
//   2.2  labels of edges and contours        relative_labels.h: the copying rule 2.1, the marking sectors of rule 2.2;
//                                            label.cpp: contours that meet nothing
//   2.3  Tables 2 and 3                      tables.h; applied by result/select.h
//        Collect and Jump                    result/link.cpp
//   2.4  polygons from contours              result/nesting.h
//
// Where it departs from the paper. There each operand is a region set already, and an edge of one is INSIDE,
// OUTSIDE, SHARED1 or SHARED2 to the other. Here a label is the winding numbers of both operands left and right
// of a chain, so that operands may overlap themselves and every fill rule is served; coincident edges are one
// chain with the sum of their changes, so neither SHARED label needs a case. A contour that meets nothing (neither
// ISECTED) asks which chain lies directly below it, all such questions in one sweep (graph/locate_below.h), where
// the paper has a point-in-region query each. Jump is worked out for all nodes at once. Polygons follow from
// connected faces, not from the smallest outer contour around a hole.
//
// Cost claimed by the paper: O(n log* n + k + z log n), n edges, k intersections, z contours, with the search for
// intersections by Finke and Hinrichs; that search apart, as here: O(n + k + z log z).
// Cost measured: docs/growth.md, beside the other engines.
#pragma once

#include "base/call_memory.h"
#include "graph/chain_graph.h"

namespace oblast::internal::leonov_nikitin {

/// By chain: the winding numbers of A and B on its right side; the left side is that plus its change.
/// Meaningful for live chains only. Cost: O(k + z log z), z connected components.
LargeArray<Winding> label(const ChainGraph& graph);

}  // namespace oblast::internal::leonov_nikitin
