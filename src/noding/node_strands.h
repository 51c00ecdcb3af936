// Stage 2, with what stage 1 left open.
//
// Some rings enter only assumed to be simple (collect.h): noding all rings together tells by the way. Where identical
// edges are merged, and so contours fall apart, they are looked at before. Contours that turn out to cross or touch
// themselves are resolved and the round is run again.
#pragma once

#include <cstdint>

#include "noding/node.h"
#include "noding/resolve.h"

namespace oblast::internal {

/// Settled strands of regions with identical edges merged. `resolved` grows by the contours that were resolved.
noding::Strands node_strands(noding::Strands strands, noding::NodingReport& report, const Resolve& resolve,
                             std::uint64_t& resolved);

}  // namespace oblast::internal
