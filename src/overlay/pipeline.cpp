#include "overlay/pipeline.h"

#include <algorithm>
#include <cmath>

#include "engines/leonov_nikitin/label.h"
#include "engines/skvortsov/extract.h"
#include "engines/vatti/label.h"
#include "noding/merge_identical_edges.h"
#include "noding/node.h"
#include "overlay/assemble.h"
#include "overlay/chain_graph.h"
#include "overlay/collect.h"
#include "overlay/link.h"
#include "overlay/nesting.h"
#include "overlay/rings.h"
#include "overlay/select.h"

namespace oblast {
namespace {

void report_noding(const noding::NodingReport& noding, const ChainGraph& graph, Statistics& statistics) {
  statistics.rounds = std::max(statistics.rounds, noding.rounds);
  statistics.largest_displacement = std::max(statistics.largest_displacement, noding.largest_displacement);
  statistics.largest_displacement_ulps =
      std::max(statistics.largest_displacement_ulps, noding.largest_displacement_ulps);
  std::vector<bool> cut(graph.node_count(), false);
  for (const Chain& chain : graph.chains)
    if (!chain.is_loop() && (graph.strands.flags[chain.first] & noding::added_flag)) cut[chain.from] = true;
  statistics.intersections += static_cast<std::uint64_t>(std::count(cut.begin(), cut.end(), true));
}

ChainGraph node_stage(noding::Strands strands, Control& control, Statistics& statistics) {
  const StageClock clock(statistics, Stage::node);
  noding::NodingReport report;
  const auto checkpoint = [&] { control.checkpoint(Stage::node, report.rounds == 0 ? 0.0 : 0.8); };
  noding::Strands noded = noding::node(noding::merge_identical_edges(std::move(strands)), report, checkpoint);
  ChainGraph graph = build_chain_graph(std::move(noded));
  report_noding(report, graph, statistics);
  return graph;
}

std::vector<Winding> label_stage(const ChainGraph& graph, Engine engine, Control& control, Statistics& statistics) {
  control.checkpoint(Stage::label, 0);
  const StageClock clock(statistics, Stage::label);
  switch (engine) {
    case Engine::vatti:
      return vatti::label(graph);
    default:
      return leonov_nikitin::label(graph);
  }
}

PipelineResult finish(Rings rings, const Nesting& nesting, const Options& options) {
  const bool touches =
      std::any_of(rings.flags.begin(), rings.flags.end(), [](std::uint8_t f) { return (f & touch_vertex) != 0; });
  return {assemble(remove_traces(std::move(rings), options.collinear), nesting), touches};
}

}  // namespace

PipelineResult run_pipeline(const RegionView& a, const RegionView* b, Operation operation, const Options& options,
                            Control& control, Statistics& statistics) {
  // 1. collect
  noding::Strands strands = collect(a, b, options, control, statistics);

  // 2. node
  const ChainGraph graph = node_stage(std::move(strands), control, statistics);

  // 3 to 5 by triangles
  if (options.engine == Engine::skvortsov) {
    skvortsov::Extracted extracted = skvortsov::extract(graph, operation, options, control, statistics);
    control.checkpoint(Stage::assemble, 0);
    const StageClock clock(statistics, Stage::assemble);
    return finish(std::move(extracted.rings), extracted.nesting, options);
  }

  // 3. label
  const std::vector<Winding> right = label_stage(graph, options.engine, control, statistics);

  // 4. select
  control.checkpoint(Stage::select, 0);
  Selection selection;
  {
    const StageClock clock(statistics, Stage::select);
    selection = select(graph, right, operation, options);
  }

  // 5. link
  control.checkpoint(Stage::link, 0);
  LinkedContours linked;
  Rings rings;
  {
    const StageClock clock(statistics, Stage::link);
    linked = link(graph, selection, options.contours);
    rings = contours_to_rings(graph, selection, linked);
  }

  // 6. assemble
  control.checkpoint(Stage::assemble, 0);
  const StageClock clock(statistics, Stage::assemble);
  const Nesting nesting = nest(graph, selection, linked, rings);
  return finish(std::move(rings), nesting, options);
}

}  // namespace oblast
