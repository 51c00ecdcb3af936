// Contacts as they are found become cuts in the order of the edges and along them, as find_meetings() returns them.
#pragma once

#include <span>

#include "base/large_pages.h"
#include "noding/clearance.h"
#include "noding/edge_contact.h"
#include "noding/settling.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

/// The cuts of all blocks, sorted by edge and along it, each once. With a `clearance` edges whose contacts are too near
/// each other are flagged; then the common ends, of which there are none otherwise, are dropped. Where the round
/// settles crossings at vertices beside an edge, cuts at which it would turn back are dropped. Cost: O(n) for cuts
/// spread evenly along edges, O(n log n) at most, and O(points).
LargeArray<EdgeCut> arrange_cuts(const Strands& strands, std::span<const std::span<const EdgeContact>> blocks,
                                 Settling settling, Clearance* clearance);

}  // namespace oblast::internal::noding
