// Clearance: decides whether rounding the crossings might change what meets what.
//
// A crossing of two edges is an exact rational point. As a vertex it is rounded: it moves by at most half a unit in the
// last place in each coordinate. Imagine that all crossings move at the same time, in straight lines, from their exact
// to their rounded positions. The first wrong meeting would be a vertex that touches a piece of which it is not an end.
// So if every vertex keeps further than twice the largest movement from every such piece, the arrangement keeps its
// form. Then a second rounding round of `overlay` finds nothing, and the decisions of a classic on exact points hold
// for the rounded points.
#pragma once

#include "noding/strands.h"

namespace oblast::internal::classics {

/// `noded` has closed strands, cut at all their meetings. Rounded vertices have added_flag, pieces with a rounded end
/// have moved_flag. True if everything keeps clear of what moved (by 2^-46 of the largest coordinate, 64 times the
/// necessary distance), and each rounded point is a vertex of exactly two edges, one of each operand. Cost: O(m n) for
/// few moved pieces m; otherwise O((n + m) log n) if boxes of edges meet few others.
bool is_clear(const noding::Strands& noded);

}  // namespace oblast::internal::classics
