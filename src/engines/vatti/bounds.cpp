// Bounds of chains, and the stops of the scan line in order.
#include "engines/vatti/bounds.h"

#include <tbb/parallel_sort.h>

namespace oblast::vatti {
namespace {

class Builder {
 public:
  explicit Builder(const ChainGraph& graph) : graph_(graph) {
    // Stops of nodes come first and have the nodes' numbers.
    result_.stops.resize(graph.node_count());
  }

  void add(std::uint32_t c) {
    const Chain& chain = graph_.chains[c];
    std::uint32_t stop = chain.is_loop() ? new_stop(chain.first) : chain.from;
    const std::uint32_t end_stop = chain.is_loop() ? stop : chain.to;
    std::uint32_t begin = chain.first;
    bool rightward = is_rightward(begin);
    for (std::uint32_t v = begin + 1; v < chain.last; ++v) {
      const bool next_rightward = is_rightward(v);
      if (next_rightward == rightward) continue;
      const std::uint32_t turn = new_stop(v);
      add_bound(begin, v, stop, turn, c, rightward);
      begin = v;
      stop = turn;
      rightward = next_rightward;
    }
    add_bound(begin, chain.last, stop, end_stop, c, rightward);
  }

  Bounds take() {
    for (std::uint32_t node = 0; node < graph_.node_count(); ++node) {
      const Stop& stop = result_.stops[node];
      if (stop.start != none || stop.finish != none)
        result_.order.push_back({graph_.point(graph_.node_vertex[node]), node});
    }
    tbb::parallel_sort(result_.order.begin(), result_.order.end(),
                       [](const PlacedStop& r, const PlacedStop& s) { return lexicographically_less(r.p, s.p); });
    return std::move(result_);
  }

 private:
  /// True when the edge that starts at the vertex runs to the right.
  bool is_rightward(std::uint32_t v) const { return lexicographically_less(graph_.point(v), graph_.point(v + 1)); }

  std::uint32_t new_stop(std::uint32_t vertex) {
    const auto stop = static_cast<std::uint32_t>(result_.stops.size());
    result_.stops.emplace_back();
    result_.order.push_back({graph_.point(vertex), stop});
    return stop;
  }

  void add_bound(std::uint32_t from, std::uint32_t to, std::uint32_t from_stop, std::uint32_t to_stop,
                 std::uint32_t chain, bool rightward) {
    const auto bound = static_cast<std::uint32_t>(result_.bounds.size());
    Stop& start = result_.stops[rightward ? from_stop : to_stop];
    const std::uint32_t top = rightward ? to_stop : from_stop;
    result_.bounds.push_back({rightward ? from : to, rightward ? to : from, chain, top, start.start});
    start.start = bound;
    result_.stops[top].finish = bound;
  }

  const ChainGraph& graph_;
  Bounds result_;
};

}  // namespace

Bounds find_bounds(const ChainGraph& graph, std::span<const std::uint32_t> chains) {
  Builder builder(graph);
  for (const std::uint32_t c : chains) builder.add(c);
  return builder.take();
}

}  // namespace oblast::vatti
