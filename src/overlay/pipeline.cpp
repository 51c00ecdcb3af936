#include "overlay/pipeline.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>

#include "base/parallel.h"
#include "engines/leonov_nikitin/label.h"
#include "engines/skvortsov/extract.h"
#include "engines/vatti/label.h"
#include "base/call_memory.h"
#include "result/assemble.h"
#include "graph/chain_graph.h"
#include "collect/collect.h"
#include "collect/independent_parts.h"
#include "result/link.h"
#include "result/nesting.h"
#include "noding/node_strands.h"
#include "result/rings.h"
#include "result/select.h"
#include "base/stage_shares.h"

namespace oblast {
namespace {

void report_noding(const noding::NodingReport& noding, const ChainGraph& graph, Statistics& statistics) {
  statistics.rounds = std::max(statistics.rounds, noding.rounds);
  statistics.largest_displacement = std::max(statistics.largest_displacement, noding.largest_displacement);
  Array<bool> cut(graph.node_count(), false);
  for (const Chain& chain : graph.chains)
    if (!chain.is_loop() && (graph.strands.flags[chain.first] & noding::added_flag)) cut[chain.from] = true;
  statistics.intersections += static_cast<std::uint64_t>(std::count(cut.begin(), cut.end(), true));
}

ChainGraph node_stage(noding::Strands strands, const Options& options, Control& control, Statistics& statistics) {
  poll();
  const Share share(Stage::node, node_share);
  const StageClock clock(control, statistics, Stage::node);
  noding::NodingReport report(options.statistics != nullptr);
  ChainGraph graph = build_chain_graph(node_strands(std::move(strands), report, control, statistics));
  if (options.statistics) report_noding(report, graph, statistics);
  return graph;
}

LargeArray<Winding> label_stage(const ChainGraph& graph, Engine engine, Control& control, Statistics& statistics) {
  poll();
  const Share share(Stage::label, label_share);
  const StageClock clock(control, statistics, Stage::label);
  switch (engine) {
    case Engine::vatti:
      return vatti::label(graph);
    default:
      return leonov_nikitin::label(graph);
  }
}

/// Contours that are not in canonical order yet. What they were made from is not needed any more.
struct Outline {
  Rings rings;
  Nesting nesting;
};

Selection label_and_select(const ChainGraph& graph, Operation operation, const Options& options, Control& control,
                           Statistics& statistics) {
  // 3. label
  const LargeArray<Winding> right = label_stage(graph, options.engine, control, statistics);

  // 4. select
  poll();
  const Share share(Stage::select, select_share);
  const StageClock clock(control, statistics, Stage::select);
  return select(graph, right, operation, options);
}

/// Stages 2 to 5, and of stage 6 what is told from the graph.
Outline outline(noding::Strands strands, Operation operation, const Options& options, Control& control,
                Statistics& statistics) {
  // 2. node
  const ChainGraph graph = node_stage(std::move(strands), options, control, statistics);

  // 3 to 5 by triangles
  if (options.engine == Engine::skvortsov) {
    skvortsov::Extracted extracted = skvortsov::extract(graph, operation, options, control, statistics);
    return {std::move(extracted.rings), std::move(extracted.nesting)};
  }

  const Selection selection = label_and_select(graph, operation, options, control, statistics);

  // 5. link
  poll();
  LinkedContours linked;
  Rings rings;
  {
    const Share share(Stage::link, link_share);
    const StageClock clock(control, statistics, Stage::link);
    linked = link(graph, selection, options.contours);
    rings = contours_to_rings(graph, selection, linked);
  }

  poll();
  const Share share(Stage::assemble, nest_share);
  const StageClock clock(control, statistics, Stage::assemble);
  Nesting nesting = nest(graph, selection, linked, rings);
  return {std::move(rings), std::move(nesting)};
}

/// Stages 2 to 6.
PipelineResult overlay_strands(noding::Strands strands, Operation operation, const Options& options, Control& control,
                               Statistics& statistics) {
  auto [rings, nesting] = outline(std::move(strands), operation, options, control, statistics);

  // 6. assemble
  poll();
  const Share share(Stage::assemble, 1);
  const StageClock clock(control, statistics, Stage::assemble);
  const bool touches =
      std::any_of(rings.flags.begin(), rings.flags.end(), [](std::uint8_t f) { return (f & touch_vertex) != 0; });
  rings = remove_traces(std::move(rings), options.collinear);
  Charge charge(bytes_of_regions(rings.points.size(), rings.size(), nesting.polygon_count));
  return {std::move(charge), assemble(rings, nesting), touches};
}

/// What parts did side by side, each stage with its share of the time that passed.
void add_parts(const Array<Statistics>& parts, double elapsed, Statistics& statistics) {
  double seconds[stage_count] = {}, total = 0;
  for (const Statistics& part : parts) {
    statistics.intersections += part.intersections;
    statistics.resolved_polygons += part.resolved_polygons;
    statistics.rounds = std::max(statistics.rounds, part.rounds);
    statistics.largest_displacement = std::max(statistics.largest_displacement, part.largest_displacement);
    for (int i = 0; i < stage_count; ++i) {
      seconds[i] += part.seconds[i];
      total += part.seconds[i];
    }
  }
  for (int i = 0; i < stage_count; ++i)
    if (total > 0) statistics.seconds[i] += elapsed * seconds[i] / total;
}

/// The batches, taken out of the strands as they are asked for. One that has most of the vertices is not copied.
class Batches {
 public:
  Batches(noding::Strands strands, const IndependentParts& parts) : strands_(std::move(strands)), parts_(parts) {
    const std::optional<std::size_t> large = find_large();
    if (!large) return;
    ready_.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (i != *large) ready_[i] = batch_of(strands_, parts, i);
    ready_[*large] = only_batch(std::move(strands_), parts, *large);
  }

  noding::Strands take(std::size_t i) { return ready_.empty() ? batch_of(strands_, parts_, i) : std::move(ready_[i]); }

 private:
  std::optional<std::size_t> find_large() const {
    for (std::size_t i = 0, s = 0; i < parts_.size(); ++i) {
      std::size_t vertices = 0;
      for (; s < parts_.ends[i]; ++s) vertices += strands_.ends[parts_.strands[s]] - strands_.begin(parts_.strands[s]);
      if (vertices > strands_.points.size() / 2) return i;
    }
    return {};
  }

  noding::Strands strands_;
  const IndependentParts& parts_;
  Array<noding::Strands> ready_;
};

PipelineResult overlay_parts(noding::Strands strands, const IndependentParts& parts, Operation operation,
                             const Options& options, Control& control, Statistics& statistics) {
  const auto begin = std::chrono::steady_clock::now();
  Array<Statistics> done(parts.size());
  Array<RegionSet> regions(parts.size());
  Array<Charge> charges(parts.size());
  std::atomic<bool> touches = false;
  const auto vertices = static_cast<double>(strands.points.size());
  Batches batches(std::move(strands), parts);
  {
    const Share all(Stage::node, parts_share);
    Share* const share_of_all = Share::current();
    const NoShare by_vertices;  // and not by the loop
    for_ranges(parts.size(), 1, [&](std::size_t i, std::size_t past) {
      for (; i < past; ++i) {
        // A thread that waits inside a part must not begin another one there: waits would nest.
        isolated([&] {
          noding::Strands part = batches.take(i);
          const Share share(share_of_all, static_cast<double>(part.points.size()) / vertices);
          PipelineResult result = overlay_strands(std::move(part), operation, options, control, done[i]);
          regions[i] = std::move(result.regions);
          charges[i] = std::move(result.charge);
          if (result.touches) touches = true;
        });
      }
    });
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  add_parts(done, elapsed.count(), statistics);
  const Share share(Stage::assemble, 1);
  const StageClock clock(control, statistics, Stage::assemble);
  std::size_t bytes = 0;
  for (const RegionSet& part : regions) bytes += bytes_of(part);
  Charge charge(bytes);
  return {std::move(charge), join(std::move(regions)), touches};
}

}  // namespace

PipelineResult run_pipeline(const RegionView& a, const RegionView* b, Operation operation, const Options& options,
                            Control& control, Statistics& statistics) {
  // 1. collect
  noding::Strands strands;
  {
    const Share share(Stage::collect, collect_share);
    strands = collect(a, b, options, control, statistics);
  }

  // 2 to 6, part by part; a small call as it is
  if (!worth_dividing(strands)) return overlay_strands(std::move(strands), operation, options, control, statistics);
  IndependentParts parts;
  {
    const Share share(Stage::collect, parting_share);
    const StageClock clock(control, statistics, Stage::collect);
    const bool both = operation == Operation::intersection;
    parts = independent_parts(strands, {both || operation == Operation::difference, both});
  }
  if (parts.size() != 1) return overlay_parts(std::move(strands), parts, operation, options, control, statistics);
  // One batch of all strands as they are is not copied.
  if (parts.strands.size() < strands.size() || !std::is_sorted(parts.strands.begin(), parts.strands.end()))
    strands = only_batch(std::move(strands), parts, 0);
  return overlay_strands(std::move(strands), operation, options, control, statistics);
}

}  // namespace oblast
