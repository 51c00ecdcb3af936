// Stage 2, with what stage 1 left open.
//
// A polygon of one ring enters as it is, assumed to be simple: to look whether it is costs as much as noding all rings
// together, which tells by the way. Only where identical edges are merged, and so contours fall apart, it is looked at
// before. Contours that turn out to cross or touch themselves are resolved and the round is run again.
#pragma once

#include "noding/node.h"
#include "overlay/control.h"

namespace oblast {

/// Settled strands of regions with identical edges merged. Adds to statistics.resolved_polygons.
noding::Strands node_strands(noding::Strands strands, noding::NodingReport& report, Control& control,
                             Statistics& statistics);

}  // namespace oblast
