// The noded chains of two operands, for tests of single steps of the engine.
#pragma once

#include <oblast/options.h>

#include "collect/collect.h"
#include "generators/hostile.h"
#include "graph/chain_graph.h"
#include "noding/node_strands.h"
#include "overlay/pipeline.h"

namespace oblast::testing {
using namespace internal;

inline ChainGraph arrangement_of(const generators::Operands& operands, const Options& options) {
  Control control(options);
  Statistics statistics;
  const RegionView a = operands.a, b = operands.b;
  noding::NodingReport report;
  return build_chain_graph(
      node_strands(collect(a, &b, options, resolve_by_pipeline(control), statistics.resolved_polygons), report,
                   resolve_by_pipeline(control), statistics.resolved_polygons));
}

}  // namespace oblast::testing
