// Pieces that a round of noding made several times: where edges overlap, each of them is cut at the ends of the others,
// and pieces of all of them lie between the same two vertices.
//
//     edges    a ------------------------- d          pieces   a b, b c, c d
//                     b ------------------------- e            b c, c d, d e
//                             c ----------- d                  c d
//
// n edges that overlap have up to n pieces between two vertices. The search tests one of them, and what it finds holds
// for all: without this, the time would be cubic in n, not quadratic as the number of pieces.
#pragma once

#include <cstdint>
#include <span>

#include "base/large_pages.h"
#include "noding/edge_contact.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

/// A piece with the same two ends as an earlier one, in either direction.
struct RepeatedPiece {
  std::uint32_t edge;
  std::uint32_t first;  ///< the first piece with these ends
};

/// Finds them among the edges flagged moved_flag, in the order of edges, and flags them repeated_flag; no other edge
/// has that flag then. The ends of all pieces that are there several times are flagged node_flag. Cost: linear,
/// expected.
LargeArray<RepeatedPiece> flag_repeated_pieces(Strands& strands);

/// Gives every repeated piece the cuts of the first one. REQUIRES: cuts sorted by edge and along it, none of a repeated
/// piece. Cost: O(r log c + the cuts), r repeated pieces, c cuts.
void copy_cuts(const Strands& strands, std::span<const RepeatedPiece> repeated, LargeArray<EdgeCut>& cuts);

}  // namespace oblast::internal::noding
