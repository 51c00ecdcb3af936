// Identical input edges become one edge with the sum of their winding changes, before any search.
//
// The inner borders of a coverage, walked once in each direction, vanish here.
#pragma once

#include "noding/strands.h"

namespace oblast::noding {

/// The strands without repeated edges: of edges with the same two ends, in either direction, one is left, as a
/// strand of its own in group 0, or none where the changes cancel. Strands break where an edge was
/// taken out. Cost: linear, expected.
Strands merge_identical_edges(Strands strands);

}  // namespace oblast::noding
