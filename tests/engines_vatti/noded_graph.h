// Stages 1 and 2 alone: a graph to label.
#pragma once

#include <oblast/region_set.h>

#include "collect/collect.h"
#include "graph/chain_graph.h"
#include "noding/node_strands.h"
#include "overlay/pipeline.h"

namespace oblast {
using namespace internal;

/// `b` may be null.
inline ChainGraph noded_graph(const RegionView& a, const RegionSet* b, const FillRule& rule) {
  Options options;
  options.fill_a = options.fill_b = rule;
  Control control(options);
  Statistics statistics;
  const RegionView b_view = b ? b->view() : RegionView{};
  noding::NodingReport report;
  return build_chain_graph(node_strands(
      collect(a, b ? &b_view : nullptr, options, resolve_by_pipeline(control), statistics.resolved_polygons), report,
      resolve_by_pipeline(control), statistics.resolved_polygons));
}

}  // namespace oblast
