// Stages 1 and 2 alone: a graph to label.
#pragma once

#include <oblast/region_set.h>

#include "support/noded.h"

namespace oblast {
using namespace internal;

/// `b` may be null.
inline ChainGraph noded_graph(const RegionView& a, const RegionSet* b, const FillRule& rule) {
  Options options;
  options.fill_a = options.fill_b = rule;
  const RegionView b_view = b ? b->view() : RegionView{};
  return testing::graph_of(a, b ? &b_view : nullptr, options);
}

}  // namespace oblast
