// Runs stages 2 to 6 on independent parts of the input, in parallel on all cores.
#pragma once

#include <functional>

#include "noding/strands.h"
#include "overlay/pipeline.h"

namespace oblast::internal {

/// Runs stages 2 to 6 on some of the strands.
using OverlayStrands = std::function<PipelineResult(noding::Strands batch, Statistics& statistics, RegionSet spare)>;

/// Joins the results of all batches. A small input, and an input with only one part, is one batch.
PipelineResult in_batches(noding::Strands strands, const Job& job, Statistics& statistics, RegionSet spare,
                          const OverlayStrands& overlay_strands);

}  // namespace oblast::internal
