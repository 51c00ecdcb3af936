// The pipeline: one function, with one call for each stage (ARCHITECTURE.md).
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include "base/memory_budget.h"
#include "base/stage_clock.h"
#include "graph/chain_graph.h"
#include "noding/resolve.h"

namespace oblast::internal {

/// The task of one run of the pipeline.
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

/// Runs stages 1 to 6. `b` may be null: then B is empty. Adds to the statistics. The result reuses the arrays of
/// `spare` if they have room.
PipelineResult run_pipeline(const RegionView& a, const RegionView* b, const Job& job, Statistics& statistics,
                            RegionSet spare = {});

/// Stage 2, for any operation.
ChainGraph node_stage(noding::Strands strands, const Job& job, Statistics& statistics);

/// A function that resolves a polygon: it runs the whole pipeline with even_odd. REQUIRES: `control` outlives it.
Resolve resolve_by_pipeline(Control& control);

}  // namespace oblast::internal
