// Two operands, cut at their meetings. Weiler-Atherton and Margalit-Knott use this.
#pragma once

#include "base/call_memory.h"
#include "base/index.h"
#include "classics/operand.h"
#include "graph/chain_graph.h"

namespace oblast::internal::classics {

/// The meetings of the edges of one operand with each other.
struct OwnMeetings {
  bool touches = false;                 ///< some vertex is on the boundary more than once
  std::uint32_t crossed_ring = none;    ///< first edge that another crosses, or touches inside it:
  std::uint32_t crossed_vertex = none;  ///< its ring and first vertex, as indices of `rings`
  std::uint32_t doubled_ring = none;    ///< first edge that coincides with another
  std::uint32_t doubled_vertex = none;
  ChainGraph graph;  ///< of the rings, changes {1, 0}; empty when an edge is crossed
};

/// Cost: O((n + k) log n).
OwnMeetings find_own_meetings(const Array<Ring>& rings);

/// Throws Error(precondition) if edges meet other than at their ends (Skvortsov, definition 6).
OwnMeetings require_regular(const Operand& operand, const Array<Ring>& rings);

/// Throws Error(precondition), with the message `why`, if the interior is not on the same side of all rings.
/// REQUIRES: the operand is regular. Cost: O(n log n).
void require_one_side(const Operand& operand, const Array<Ring>& rings, const OwnMeetings& own, const char* why,
                      bool& interior_left);

/// Both operands, cut once where they meet. The changes of A are {1, 0}, those of B are {0, 1}.
struct Arrangement {
  ChainGraph graph;
  std::uint64_t meetings = 0;  ///< number of points that are on both boundaries
  bool clear = false;          ///< see clearance.h; if it is false, the graph must not be used
};

/// REQUIRES: both are regular, with the interior on the left. `touches` is from find_own_meetings.
/// Cost: O((n + k) log n).
Arrangement arrange(const Array<Ring>& a, bool a_touches, const Array<Ring>& b, bool b_touches);

}  // namespace oblast::internal::classics
