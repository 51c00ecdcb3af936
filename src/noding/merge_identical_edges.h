// Identical input edges become one edge with the sum of their winding changes, before any search.
//
// The inner borders of a coverage, walked once in each direction, vanish here.
#pragma once

#include <utility>

#include "noding/strands.h"

namespace oblast::noding {

/// By edge, the first edge with the same two ends, in either direction, where there is another one; 0xffffffff for all
/// others. Empty where no two edges are identical. Cost: linear, expected.
std::vector<std::uint32_t> identical_edges(const Strands& strands);

/// The strands without repeated edges: of identical edges one is left, as a strand of its own in group 0, or none where
/// the changes cancel. Strands break where an edge was taken out. Cost: linear.
Strands merge_identical_edges(Strands strands, const std::vector<std::uint32_t>& identical);
inline Strands merge_identical_edges(Strands strands) {
  const std::vector<std::uint32_t> identical = identical_edges(strands);
  return merge_identical_edges(std::move(strands), identical);
}

}  // namespace oblast::noding
