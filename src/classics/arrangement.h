// Two operands cut at their meetings: what Weiler-Atherton and Margalit-Knott work on.
#pragma once

#include "base/call_memory.h"
#include "base/index.h"
#include "classics/operand.h"
#include "graph/chain_graph.h"

namespace oblast::internal::classics {

/// The meetings of one operand's edges with each other.
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

/// Throws Error(precondition) unless edges meet at their ends only (Skvortsov, definition 6).
OwnMeetings require_regular(const Operand& operand, const Array<Ring>& rings);

/// Throws Error(precondition), with `why`, unless the interior is on the same side of all rings as they are directed.
/// REQUIRES: regular. Cost: O(n log n).
void require_one_side(const Operand& operand, const Array<Ring>& rings, const OwnMeetings& own, const char* why,
                      bool& interior_left);

/// Both operands, A's changes {1, 0} and B's {0, 1}, cut where they meet, once.
struct Arrangement {
  ChainGraph graph;
  std::uint64_t meetings = 0;  ///< points of both boundaries
  bool clear = false;          ///< see clearance.h; when false the graph is of no use
};

/// REQUIRES: both regular, with the interior on the left. `touches` as found by find_own_meetings.
/// Cost: O((n + k) log n).
Arrangement arrange(const Array<Ring>& a, bool a_touches, const Array<Ring>& b, bool b_touches);

}  // namespace oblast::internal::classics
