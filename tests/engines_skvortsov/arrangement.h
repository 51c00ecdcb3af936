// The noded chains of two operands, for tests of single steps of the engine.
#pragma once

#include <oblast/options.h>

#include "generators/hostile.h"
#include "noding/merge_identical_edges.h"
#include "noding/node.h"
#include "overlay/chain_graph.h"
#include "overlay/collect.h"

namespace oblast::testing {

inline ChainGraph arrangement_of(const generators::Operands& operands, const Options& options) {
  Control control(options.progress);
  Statistics statistics;
  const RegionView a = operands.a, b = operands.b;
  noding::NodingReport report;
  return build_chain_graph(
      noding::node(noding::merge_identical_edges(collect(a, &b, options, control, statistics)), report));
}

}  // namespace oblast::testing
