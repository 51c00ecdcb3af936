// The pipeline: one function, one call a stage (ARCHITECTURE.md).
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include "base/memory_budget.h"
#include "base/stage_clock.h"
#include "graph/chain_graph.h"
#include "noding/resolve.h"

namespace oblast::internal {

/// What one run of the pipeline is asked for.
struct Job {
  Operation operation;
  const Options& options;
  Control& control;
};

struct PipelineResult {
  Charge charge;  ///< for the regions
  RegionSet regions;
  bool touches = false;  ///< some vertex is on the boundary more than once
};

/// Stages 1 to 6. `b` may be null: then the operation sees an empty B. Adds to the statistics. The result comes in the
/// arrays of `spare` where they have room.
PipelineResult run_pipeline(const RegionView& a, const RegionView* b, const Job& job, Statistics& statistics,
                            RegionSet spare = {});

/// Stage 2, for any operation.
ChainGraph node_stage(noding::Strands strands, const Job& job, Statistics& statistics);

/// A polygon by itself: the whole pipeline under even_odd. For as long as `control` lives.
Resolve resolve_by_pipeline(Control& control);

}  // namespace oblast::internal
