// Stages 1 and 2 alone: a graph to label.
#pragma once

#include <oblast/region_set.h>

#include "noding/merge_identical_edges.h"
#include "noding/node.h"
#include "overlay/chain_graph.h"
#include "overlay/collect.h"

namespace oblast {

/// `b` may be null.
inline ChainGraph noded_graph(const RegionView& a, const RegionSet* b, const FillRule& rule) {
  Options options;
  options.fill_a = options.fill_b = rule;
  Control control(options.progress);
  Statistics statistics;
  const RegionView b_view = b ? b->view() : RegionView{};
  noding::NodingReport report;
  return build_chain_graph(noding::node(
      noding::merge_identical_edges(collect(a, b ? &b_view : nullptr, options, control, statistics)), report));
}

}  // namespace oblast
