// Cutting: the found points become vertices.
#pragma once

#include <span>

#include "noding/meetings.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

/// Inserts every cut as a vertex flagged node_flag | added_flag. The pieces of a cut edge, and only they, are flagged
/// moved_flag where the edge had near_flag: rounding may have bent them. Cost: linear; no copy where the points have
/// room for the cuts.
/// REQUIRES: cuts sorted by edge and along it, each once.
void insert_cuts(Strands& strands, std::span<const EdgeCut> cuts);

}  // namespace oblast::internal::noding
