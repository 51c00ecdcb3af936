// Independent parts of the input, each through stages 2 to 6, side by side on all cores.
#pragma once

#include <functional>

#include "noding/strands.h"
#include "overlay/pipeline.h"

namespace oblast::internal {

/// Stages 2 to 6 on some of the strands.
using OverlayStrands = std::function<PipelineResult(noding::Strands batch, Statistics& statistics, RegionSet spare)>;

/// The results of all batches put together. A small input, and one that does not fall into parts, is one batch.
PipelineResult in_batches(noding::Strands strands, const Job& job, Statistics& statistics, RegionSet spare,
                          const OverlayStrands& overlay_strands);

}  // namespace oblast::internal
