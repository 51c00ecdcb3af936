#include "overlay/pipeline.h"

#include <algorithm>

#include "base/call_memory.h"
#include "base/stage_shares.h"
#include "collect/collect.h"
#include "engines/leonov_nikitin/label.h"
#include "engines/skvortsov/extract.h"
#include "engines/vatti/label.h"
#include "graph/chain_graph.h"
#include "noding/node_strands.h"
#include "overlay/batches.h"
#include "result/assemble.h"
#include "result/link.h"
#include "result/nesting.h"
#include "result/remove_traces.h"
#include "result/rings.h"
#include "result/select.h"

namespace oblast::internal {
namespace {

void report(const noding::NodingReport& noding, const ChainGraph& graph, Statistics& statistics) {
  statistics.rounds = std::max(statistics.rounds, noding.rounds);
  statistics.largest_displacement = std::max(statistics.largest_displacement, noding.largest_displacement);
  Array<bool> cut(graph.node_count(), false);
  for (const Chain& chain : graph.chains)
    if (!chain.is_loop() && (graph.strands.flags[chain.first] & noding::added_flag)) cut[chain.from] = true;
  statistics.intersections += static_cast<std::uint64_t>(std::count(cut.begin(), cut.end(), true));
}

LargeArray<Winding> label_stage(const ChainGraph& graph, const Job& job, Statistics& statistics) {
  const InStage stage(Stage::label, label_share, job.control, statistics);
  return job.options.engine == Engine::vatti ? vatti::label(graph) : leonov_nikitin::label(graph);
}

Selection select_stage(const ChainGraph& graph, const LargeArray<Winding>& right, const Job& job,
                       Statistics& statistics) {
  const InStage stage(Stage::select, select_share, job.control, statistics);
  return select(graph, right, job.operation, job.options);
}

/// Contours that are not yet in canonical order, and their nesting.
struct Outline {
  Rings rings;
  Nesting nesting;
};

Outline link_stage(const ChainGraph& graph, const Selection& selection, const Job& job, Statistics& statistics) {
  LinkedContours linked;
  Outline outline;
  {
    const InStage stage(Stage::link, link_share, job.control, statistics);
    linked = link(graph, selection, job.options.contours);
    outline.rings = contours_to_rings(graph, selection, linked);
  }
  const InStage stage(Stage::assemble, nest_share, job.control, statistics);
  outline.nesting = nest(graph, selection, linked, outline.rings);
  return outline;
}

/// Stages 2 to 5. At the end, everything that they made except the outline is freed.
Outline outline(noding::Strands strands, const Job& job, Statistics& statistics) {
  const ChainGraph graph = node_stage(std::move(strands), job, statistics);  // 2
  if (job.options.engine == Engine::skvortsov) {                             // 3 to 5 by triangles
    skvortsov::Extracted extracted = skvortsov::extract(graph, job.operation, job.options, job.control, statistics);
    return {std::move(extracted.rings), std::move(extracted.nesting)};
  }
  const Selection selection = select_stage(graph, label_stage(graph, job, statistics), job, statistics);  // 3, 4
  return link_stage(graph, selection, job, statistics);                                                   // 5
}

PipelineResult assemble_stage(Rings rings, const Nesting& nesting, const Job& job, Statistics& statistics,
                              RegionSet spare) {
  const InStage stage(Stage::assemble, 1, job.control, statistics);
  const bool touches =
      std::any_of(rings.flags.begin(), rings.flags.end(), [](std::uint8_t f) { return (f & touch_vertex) != 0; });
  rings = remove_traces(std::move(rings), job.options.collinear);
  Charge charge(bytes_of_regions(rings.points.size(), rings.size(), nesting.polygon_count));
  return {std::move(charge), assemble(rings, nesting, std::move(spare)), touches};
}

/// What a part must hold to matter.
PartNeeds needs_of(Operation operation) {
  const bool both = operation == Operation::intersection;
  return {both || operation == Operation::difference, both};
}

/// What batches leave.
struct BatchResults {
  const Job& job;
  RegionSet spare;  ///< for the result
  Array<PipelineResult> of;

  void run(std::size_t batch, noding::Strands strands, Statistics& statistics) {
    Outline contours = outline(std::move(strands), job, statistics);  // 2 to 5
    of[batch] = assemble_stage(std::move(contours.rings), contours.nesting, job, statistics,
                               of.size() == 1 ? std::move(spare) : RegionSet{});  // 6
  }
};

/// The polygons of all batches, in order.
PipelineResult join_results(Array<PipelineResult> results, const Job& job, Statistics& statistics, RegionSet spare) {
  if (results.size() == 1) return std::move(results[0]);
  const Share share(Stage::assemble, 1);
  const StageClock clock(job.control, statistics, Stage::assemble);
  Array<RegionSet> regions;
  regions.reserve(results.size());
  std::size_t bytes = 0;
  bool touches = false;
  for (PipelineResult& result : results) {
    bytes += bytes_of(result.regions);
    touches |= result.touches;
    regions.push_back(std::move(result.regions));
  }
  Charge charge(bytes);
  return {std::move(charge), join(std::move(regions), std::move(spare)), touches};
}

}  // namespace

Resolve resolve_by_pipeline(Control& control) {
  return [&control](const RegionView& rings) {
    Options options;
    options.fill_a = FillRule::even_odd();
    Statistics statistics;
    options.statistics = &statistics;
    PipelineResult result = run_pipeline(rings, nullptr, {Operation::unite, options, control}, statistics);
    const bool met = statistics.intersections > 0 || result.touches;
    return Resolved{std::move(result.charge), std::move(result.regions), met, result.touches};
  };
}

ChainGraph node_stage(noding::Strands strands, const Job& job, Statistics& statistics) {
  const InStage stage(Stage::node, node_share, job.control, statistics);
  noding::NodingReport noding(job.options.statistics != nullptr);
  ChainGraph graph = build_chain_graph(
      node_strands(std::move(strands), noding, resolve_by_pipeline(job.control), statistics.resolved_polygons));
  if (job.options.statistics) report(noding, graph, statistics);
  return graph;
}

PipelineResult run_pipeline(const RegionView& a, const RegionView* b, const Job& job, Statistics& statistics,
                            RegionSet spare) {
  noding::Strands strands;
  {
    const InStage stage(Stage::collect, collect_share, job.control, statistics);
    strands = collect(a, b, job.options, resolve_by_pipeline(job.control), statistics.resolved_polygons);  // 1
  }
  BatchResults results{job, std::move(spare), {}};
  // Each function holds one reference, so neither needs memory of its own.
  in_batches(std::move(strands), needs_of(job.operation), job.control, statistics,
             {[&results](std::size_t count) { results.of.resize(count); },
              [&results](std::size_t batch, noding::Strands of_batch, Statistics& done) {
                results.run(batch, std::move(of_batch), done);
              }});
  return join_results(std::move(results.of), job, statistics, std::move(results.spare));
}

}  // namespace oblast::internal
