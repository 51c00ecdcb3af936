// Identical input edges become one edge with the sum of their winding changes, before any search.
//
// The inner borders of a coverage, walked once in each direction, vanish here.
#pragma once

#include <cstdint>
#include <utility>

#include "base/index.h"
#include "base/large_pages.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

/// Edges with the same two ends, in either direction.
struct IdenticalEdges {
  LargeArray<std::uint32_t> first_of;  ///< by edge: the first one with its ends; none where it is the only one
  LargeArray<Winding> sum;             ///< by such a first edge: of all their changes, in its direction; else anything

  bool empty() const { return first_of.empty(); }
};

/// How carefully identical edges are looked for.
enum class Seek {
  no,           ///< not at all
  if_frequent,  ///< all of them; none if a sample of many edges has no two that are identical
  all,
};

/// Cost: linear, expected.
IdenticalEdges identical_edges(const Strands& strands, Seek seek = Seek::all);

/// The strands without repeated edges: of identical ones one is left, as a strand of its own in group 0, or none where
/// the changes cancel. Strands break where an edge was taken out. Cost: linear.
Strands merge_identical_edges(Strands strands, const IdenticalEdges& identical);
inline Strands merge_identical_edges(Strands strands) {
  const IdenticalEdges identical = identical_edges(strands);
  return merge_identical_edges(std::move(strands), identical);
}

}  // namespace oblast::internal::noding
