// Cuts in the order of the edges and along them: what find_meetings() returns, of the cuts as they are found.
#pragma once

#include <span>

#include "base/large_pages.h"
#include "noding/clearance.h"
#include "noding/meetings.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

/// The cuts of all blocks, sorted by edge and along it, each once. With a `clearance` edges whose cuts are too near
/// each other are flagged, and cuts at an end of their edge, which stand for common ends, dropped. Where the round
/// settles crossings at vertices beside an edge, cuts at which it would turn back are dropped. Cost: O(n) for cuts
/// spread evenly along edges, O(n log n) at most, and O(points).
LargeArray<EdgeCut> arrange_cuts(const Strands& strands, std::span<const std::span<const EdgeCut>> blocks,
                                 Settling settling, Clearance* clearance);

}  // namespace oblast::internal::noding
