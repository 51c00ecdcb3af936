// Finds the vertices of the result that noding added, and those at which the result touches itself.
#include <algorithm>
#include <atomic>
#include <utility>

#include "base/fetch.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "result/rings.h"

namespace oblast::internal {
namespace {

/// Without branches: chains are in the order of nodes, so the processor cannot predict the conditions.
template <class... Bool>
bool all(Bool... conditions) {
  return static_cast<bool>((static_cast<int>(conditions) & ...));
}

/// Finds the trace vertices: vertices that noding added, at which the result has exactly two edges, both pieces of one
/// input edge, and at which no live edge has a vertex of the input.
class TraceFinder {
 public:
  TraceFinder(const ChainGraph& graph, const Selection& selection)
      : graph_(graph), selection_(selection), flags_(graph.node_count(), 0) {}

  NodeKinds run() {
    flag_touches();
    find_sources();
    return {std::move(flags_), std::move(sources_)};
  }

 private:
  static constexpr std::size_t elements_a_task = tuning::classified_elements_a_task;

  bool added(std::uint32_t vertex) const { return (graph_.strands.flags[vertex] & noding::added_flag) != 0; }
  bool is_selected(const Chain& chain) const { return selection_[chain.merged_into] != none; }

  /// Chains are visited in order, but their vertices are spread over all strands.
  void fetch_flags_ahead(std::size_t chain) const {
    if (chain + fetched_ahead < graph_.chains.size())
      fetch(&graph_.strands.flags[graph_.chains[chain + fetched_ahead].first]);
  }

  void fetch_before_ahead(std::size_t chain) const {
    if (chain + fetched_ahead >= graph_.chains.size()) return;
    const std::uint32_t before = graph_.chains[chain + fetched_ahead].before;
    fetch(&graph_.chains[before == none ? chain : before]);
  }

  void flag_touches() {
    resize_with_zeros(degree_, graph_.node_count());
    for_ranges(graph_.node_count(), elements_a_task, [&](std::size_t begin, std::size_t end) {
      for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
        std::uint32_t degree = 0;
        for (const Descriptor d : graph_.list(node)) degree += selection_[chain_of(d)] != none;
        degree_[node] = degree;
        flags_[node] = degree > 2 ? touch_vertex : 0;
      }
    });
  }

  void find_sources() {
    Array<std::uint8_t> input_vertex(graph_.node_count(), 0);
    const auto note = [&](std::uint32_t node) {
      std::atomic_ref(input_vertex[node]).store(1, std::memory_order_relaxed);
    };
    for_ranges(graph_.first_loop, elements_a_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        fetch_flags_ahead(c);
        const Chain& chain = graph_.chains[c];
        const bool live = graph_.is_live(chain.merged_into);
        if (all(live, degree_[chain.from] == 2, !added(chain.first))) note(chain.from);
        if (all(live, degree_[chain.to] == 2, !added(chain.last))) note(chain.to);
      }
    });
    Array<Array<TraceEdge>> found(range_count(graph_.first_loop, elements_a_task));
    for_numbered_ranges(graph_.first_loop, elements_a_task, [&](std::size_t i, std::size_t begin, std::size_t end) {
      // Two consecutive chains of a strand that share an added vertex are pieces of one input edge.
      for (std::size_t c = begin; c < end; ++c) {
        fetch_flags_ahead(c);
        fetch_before_ahead(c);
        const Chain& after = graph_.chains[c];
        const bool between = after.before != none && added(after.first);
        if (!all(between, degree_[after.from] == 2, !input_vertex[after.from], is_selected(after))) continue;
        const Chain& before = graph_.chains[after.before];
        if (!is_selected(before) || before.merged_into == after.merged_into) continue;
        found[i].push_back({after.from, graph_.strands.origin[after.first]});
      }
    });
    for (const Array<TraceEdge>& part : found) sources_.insert(sources_.end(), part.begin(), part.end());
    for (const TraceEdge& source : sources_) flags_[source.at] |= trace_vertex;
    parallel_sort(sources_.begin(), sources_.end());
    sources_.erase(std::unique(sources_.begin(), sources_.end()), sources_.end());
  }

  const ChainGraph& graph_;
  const Selection& selection_;
  Array<std::uint8_t> flags_;
  Array<std::uint32_t> degree_;
  Array<TraceEdge> sources_;
};

}  // namespace

NodeKinds classify_nodes(const ChainGraph& graph, const Selection& selection) {
  return TraceFinder(graph, selection).run();
}

}  // namespace oblast::internal
