// Clearance: may rounding the crossings change what meets what?
//
// A crossing of two edges is an exact rational point; as a vertex it is rounded, and moves by at most
// half a unit in the last place in each coordinate. Let all crossings move at once, straight, from the exact
// to the rounded place. A first wrong meeting would be a vertex touching a piece it is no end of. So if
// every vertex keeps further than twice the largest movement from every piece it is no end of, the arrangement
// keeps its form: a second rounding round of `overlay` finds nothing, and what a classic decided on exact
// points holds for the rounded ones.
#pragma once

#include "noding/strands.h"

namespace oblast::internal::classics {

/// `noded`: closed strands cut at all their meetings. Vertices that were rounded are flagged added_flag,
/// pieces with a rounded end moved_flag. True when everything keeps well away (2^-46 of the largest
/// coordinate, 64 times what is needed) from what moved, and each rounded point is a vertex of just two edges, one of
/// each operand. Cost: O(m n) for a few moved pieces m, else O((n + m) log n) where boxes of edges meet few others.
bool is_clear(const noding::Strands& noded);

}  // namespace oblast::internal::classics
