// The pipeline: one function, one call a stage.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include "base/memory_budget.h"
#include "base/stage_clock.h"

namespace oblast {

struct PipelineResult {
  Charge charge;  ///< for the regions
  RegionSet regions;
  bool touches = false;  ///< some vertex is on the boundary more than once
};

/// Stages 1 to 6 (ARCHITECTURE.md). `b` may be null: then the operation sees an empty B.
PipelineResult run_pipeline(const RegionView& a, const RegionView* b, Operation operation, const Options& options,
                            Control& control, Statistics& statistics);

}  // namespace oblast
