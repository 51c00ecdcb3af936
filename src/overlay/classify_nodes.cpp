// Which vertices of the result noding left behind, and where the result touches itself.
#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "base/parallel.h"
#include "base/tuning.h"
#include "memory/fetch.h"
#include "memory/large_pages.h"
#include "overlay/rings.h"

namespace oblast {
namespace {

/// Without branches: chains come node by node, so each condition is hard to foresee.
template <class... Bool>
bool all(Bool... conditions) {
  return static_cast<bool>((static_cast<int>(conditions) & ...));
}

/// Finds the trace vertices: places added by noding, no vertex of an edge that still changes a winding
/// number, where the result has just two pieces of one input edge.
class TraceFinder {
 public:
  TraceFinder(const ChainGraph& graph, const Selection& selection)
      : graph_(graph), selection_(selection), flags_(graph.node_count(), 0) {}

  Array<std::uint8_t> run() {
    flag_touches();
    find_sources();
    if (!sources_.empty()) {
      find_neighbours();
      part_unrelated_neighbours();
      check_runs();
    }
    return std::move(flags_);
  }

 private:
  static constexpr std::size_t elements_a_task = tuning::classified_elements_a_task;

  struct Source {
    std::uint32_t node;
    std::uint32_t edge;  ///< input edge whose pieces meet at the node

    friend bool operator==(const Source&, const Source&) = default;
    friend bool operator<(const Source& p, const Source& q) {
      return p.node != q.node ? p.node < q.node : p.edge < q.edge;
    }
  };
  struct Neighbours {
    std::uint32_t node[2] = {none, none};  ///< trace nodes one result edge away
  };

  bool added(std::uint32_t vertex) const { return (graph_.strands.flags[vertex] & noding::added_flag) != 0; }
  bool is_selected(const Chain& chain) const { return selection_[chain.merged_into] != none; }
  bool is_trace(std::uint32_t node) const { return (flags_[node] & trace_vertex) != 0; }

  /// Chains are looked at in order, and their vertices are all over the strands.
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
    resize_in_large_pages(degree_, graph_.node_count());
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
    Array<Array<Source>> found(range_count(graph_.first_loop, elements_a_task));
    for_numbered_ranges(graph_.first_loop, elements_a_task, [&](std::size_t i, std::size_t begin, std::size_t end) {
      // Chains that follow one another in a strand at an added vertex are pieces of one input edge.
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
    for (const Array<Source>& part : found) sources_.insert(sources_.end(), part.begin(), part.end());
    for (const Source& source : sources_) flags_[source.node] |= trace_vertex;
    std::sort(sources_.begin(), sources_.end());
    sources_.erase(std::unique(sources_.begin(), sources_.end()), sources_.end());
  }

  Array<std::uint32_t> edges_at(std::uint32_t node) const {
    Array<std::uint32_t> edges;
    for (auto it = std::lower_bound(sources_.begin(), sources_.end(), Source{node, 0});
         it != sources_.end() && it->node == node; ++it)
      edges.push_back(it->edge);
    return edges;
  }

  static Array<std::uint32_t> common(const Array<std::uint32_t>& p, const Array<std::uint32_t>& q) {
    Array<std::uint32_t> both;
    std::set_intersection(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(both));
    return both;
  }

  void find_neighbours() {
    neighbours_.assign(graph_.node_count(), {});
    for (std::uint32_t c = 0; c < selection_.size(); ++c) {
      const Chain& chain = graph_.chains[c];
      if (selection_[c] == none || chain.is_loop() || chain.last - chain.first > 1) continue;
      if (!is_trace(chain.from) || !is_trace(chain.to)) continue;
      for (const auto& [node, other] : {std::pair{chain.from, chain.to}, std::pair{chain.to, chain.from}})
        neighbours_[node].node[neighbours_[node].node[0] == none ? 0 : 1] = other;
    }
  }

  /// Two neighbours that are traces of different edges hold a corner between them: both stay.
  void part_unrelated_neighbours() {
    Array<std::uint32_t> stay;
    for (std::uint32_t node = 0; node < flags_.size(); ++node) {
      for (const std::uint32_t other : neighbours_[node].node)
        if (other != none && common(edges_at(node), edges_at(other)).empty()) stay.push_back(node);
    }
    for (const std::uint32_t node : stay) flags_[node] &= static_cast<std::uint8_t>(~trace_vertex);
  }

  /// A run of neighbours is straightened into one edge only if all are traces of one input edge.
  void check_runs() {
    Array<bool> visited(flags_.size(), false);
    Array<std::uint32_t> run;
    for (std::uint32_t node = 0; node < flags_.size(); ++node) {
      if (!is_trace(node) || visited[node]) continue;
      run.assign(1, node);
      visited[node] = true;
      Array<std::uint32_t> edges = edges_at(node);
      for (std::size_t i = 0; i < run.size(); ++i) {
        for (const std::uint32_t other : neighbours_[run[i]].node) {
          if (other == none || !is_trace(other) || visited[other]) continue;
          visited[other] = true;
          run.push_back(other);
          edges = common(edges, edges_at(other));
        }
      }
      if (!edges.empty()) continue;
      for (const std::uint32_t other : run) flags_[other] &= static_cast<std::uint8_t>(~trace_vertex);
    }
  }

  const ChainGraph& graph_;
  const Selection& selection_;
  Array<std::uint8_t> flags_;
  Array<std::uint32_t> degree_;
  Array<Source> sources_;
  Array<Neighbours> neighbours_;
};

}  // namespace

Array<std::uint8_t> classify_nodes(const ChainGraph& graph, const Selection& selection) {
  return TraceFinder(graph, selection).run();
}

}  // namespace oblast
