// Cutting: the found points become vertices.
#pragma once

#include <span>

#include "noding/meetings.h"
#include "noding/strands.h"

namespace oblast::noding {

/// The strands with every cut inserted as a vertex flagged node_flag | added_flag. The pieces of a cut
/// edge, and only they, are flagged moved_flag: rounding may have bent them. Cost: linear.
/// REQUIRES: cuts sorted by edge and along it, each once.
Strands insert_cuts(const Strands& strands, std::span<const EdgeCut> cuts);

}  // namespace oblast::noding
