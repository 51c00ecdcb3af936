// Identical input edges become one edge with the sum of their winding changes, before any search.
//
// The inner borders of a coverage, walked once in each direction, vanish here.
#pragma once

#include <utility>

#include "noding/identical_edges.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

/// The strands without repeated edges: of identical ones one is left, or none if the changes cancel. Strands break
/// where the change does. Cost: linear.
Strands merge_identical_edges(Strands strands, const IdenticalEdges& identical);
inline Strands merge_identical_edges(Strands strands) {
  const IdenticalEdges identical = identical_edges(strands);
  return merge_identical_edges(std::move(strands), identical);
}

}  // namespace oblast::internal::noding
