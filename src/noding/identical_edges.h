// Finding identical edges: those with the same two ends, in either direction.
//
//     a --- e3 --- b          first_of    e3: e3, e7: e3, all others: none
//     b --- e7 --- a          sum         e3: the change of e3 minus the change of e7
//
// Most inputs have few of them. So a few bits of a hash tell for most edges that there is no other edge with the same
// ends (edge_hashes.h), and only the others are looked up in a table. Where many edges are repeated, all are.
#pragma once

#include <cstdint>

#include "base/index.h"
#include "base/large_pages.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

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

}  // namespace oblast::internal::noding
