// The engine of Skvortsov (Vychislitel'nye Metody i Programmirovanie 3, 2002, pp. 116-123): overlay by a constrained
// triangulation.
//
//   1. Triangulate: all sides become constraints, which store how the winding numbers change across them
//      (marked_mesh.h).                                                  the paper's section 3, step 1
//   2. Classify: eat the triangles inwards from the hull. Flood the outside, step across marked sides,
//      flood, step, until no triangle is left (classify.h).              section 3.1
//   3. Select: apply the truth table of the operation to each triangle.  section 3, step 3
//   4. Extract: walk along the sides between kept and dropped triangles. At a vertex with a choice,
//      follow one sector (contours.h).                                   section 3.2
//
// Differences from the paper: Intersections come from the noder, which all engines share. The paper marks sides that
// occur an odd number of times; here a side stores the changes of the winding numbers of both operands, so one pass
// classifies for both operands and for every fill rule. The paper walks with the interior on the right and turns right;
// here the interior is on the left, and the walk turns left.
//
// Cost that the paper states: O(n log n) in the worst case, O(n) on average. Measured on one thread of a busy 2-core
// EPYC, with two stars of 10^4, 10^5 and 10^6 vertices each: steps 1 to 4 take about 0.5, 0.9 and 1.0 us per vertex
// (the growth comes from the caches). That is two to three times the time of the whole pipeline with the default
// engine.
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

/// Uses the noded chains and their changes of winding numbers, not the connectivity lists. Throws Error: cancelled;
/// too_large for 2^29 vertices or more.
Extracted extract(const ChainGraph& graph, Operation operation, const Options& options, Control& control,
                  Statistics& statistics);

}  // namespace oblast::internal::skvortsov
