#include "support/noded.h"

#include "collect/collect.h"
#include "noding/node_strands.h"
#include "overlay/pipeline.h"

namespace oblast::testing {
using namespace internal;

ChainGraph graph_of(const RegionView& a, const RegionView* b, const Options& options) {
  Control control(options);
  Statistics statistics;
  noding::NodingReport report;
  noding::Strands strands = collect(a, b, options, resolve_by_pipeline(control), statistics.resolved_polygons);
  return build_chain_graph(
      node_strands(std::move(strands), report, resolve_by_pipeline(control), statistics.resolved_polygons));
}

}  // namespace oblast::testing
