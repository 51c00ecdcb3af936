// The engine of Skvortsov (Vychislitel'nye Metody i Programmirovanie 3, 2002, pp. 116-123): overlays by a
// constrained triangulation.
//
//   1. Triangulate: all sides become constraints, each knowing how the windings change across it
//      (marked_mesh.h).                                                  the paper's section 3, step 1
//   2. Classify: eat the triangles inwards from the hull: flood the outside, step across marked
//      sides, flood, step, until none is left (classify.h).              section 3.1
//   3. Select: the operation's truth table for each triangle.            section 3, step 3
//   4. Extract: sides between kept and dropped triangles, walked into contours; at a vertex with a choice
//      the turn that hugs one sector (contours.h).                       section 3.2
//
// Where it departs from the paper: intersections come from the noder, which all engines share; instead of
// "an odd number of times" a side knows by how much it changes the winding numbers of both operands, so
// one pass classifies for both and for every fill rule; and where the paper walks with the interior on the
// right and turns right, contours here have it on the left, so the walk turns left.
//
// Cost claimed: O(n log n) at worst, O(n) on average. Cost measured, one thread of a busy 2-core EPYC: two
// wiggly polygons of 10^4, 10^5 and 10^6 vertices each: steps 1 to 4 take about 0.5, 0.9 and 1.0 us a vertex
// (memory caches account for the growth), twice to three times the default engine's whole pipeline.
#pragma once

#include <oblast/options.h>

#include "base/stage_clock.h"
#include "result/nesting.h"
#include "result/rings.h"

namespace oblast::internal::skvortsov {

/// The contours of the result with their polygons, before canonical order.
struct Extracted {
  Rings rings;
  Nesting nesting;
};

/// From the noded chains and their winding changes; connectivity lists are not used. Throws Error: cancelled,
/// too_large (from 2^29 vertices).
Extracted extract(const ChainGraph& graph, Operation operation, const Options& options, Control& control,
                  Statistics& statistics);

}  // namespace oblast::internal::skvortsov
