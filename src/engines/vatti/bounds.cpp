// Finds the bounds of chains, and sorts the stops of the scan line.
#include "engines/vatti/bounds.h"

#include <algorithm>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "exact/orientation.h"

namespace oblast::internal::vatti {
namespace {

/// A bound, with the numbers that its stops had when they were found.
struct FoundBound {
  std::uint32_t first, last, chain, start, top;
  std::uint32_t rank = 0;  ///< among the bounds of its start, in the order they were found
};

/// A stop with its point, for sorting.
struct PlacedStop {
  Point p;
  std::uint32_t stop;
};

/// Step 1: divides chains into bounds. Stops at nodes have the numbers of the nodes; other stops follow.
class Finder {
 public:
  Finder(const ChainGraph& graph, std::size_t chain_count)
      : graph_(graph), is_stop_(graph.node_count(), 0), stop_count_(static_cast<std::uint32_t>(graph.node_count())) {
    bounds_.reserve(chain_count + chain_count / 4);
    stops_.reserve(graph.node_count());
  }

  void add(std::uint32_t c) {
    const Chain& chain = graph_.chains[c];
    std::uint32_t stop = chain.is_loop() ? new_stop(chain.first) : node_stop(chain.from);
    const std::uint32_t end_stop = chain.is_loop() ? stop : node_stop(chain.to);
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

  Array<FoundBound>& bounds() { return bounds_; }
  Array<PlacedStop>& stops() { return stops_; }
  std::uint32_t stop_count() const { return stop_count_; }  ///< includes the stops of dead nodes

 private:
  /// True if the edge that starts at the vertex runs to the right.
  bool is_rightward(std::uint32_t v) const { return lexicographically_less(graph_.point(v), graph_.point(v + 1)); }

  std::uint32_t new_stop(std::uint32_t vertex) {
    stops_.push_back({graph_.point(vertex), stop_count_});
    return stop_count_++;
  }

  std::uint32_t node_stop(std::uint32_t node) {
    if (!is_stop_[node]) stops_.push_back({graph_.point(graph_.node_vertex[node]), node});
    is_stop_[node] = 1;
    return node;
  }

  void add_bound(std::uint32_t from, std::uint32_t to, std::uint32_t from_stop, std::uint32_t to_stop,
                 std::uint32_t chain, bool rightward) {
    if (rightward)
      bounds_.push_back({from, to, chain, from_stop, to_stop});
    else
      bounds_.push_back({to, from, chain, to_stop, from_stop});
  }

  const ChainGraph& graph_;
  Array<std::uint8_t> is_stop_;  ///< by node
  std::uint32_t stop_count_;
  Array<FoundBound> bounds_;
  Array<PlacedStop> stops_;
};

/// Step 2: the sorted stops, each with room for the bounds that start there. Writes to `place_of`, for each number of a
/// stop, its place in the order.
Array<Stop> order_stops(Finder& found, Array<std::uint32_t>& place_of) {
  Array<PlacedStop>& placed = found.stops();
  parallel_sort(placed.begin(), placed.end(),
                [](const PlacedStop& r, const PlacedStop& s) { return lexicographically_less(r.p, s.p); });
  place_of.resize(found.stop_count());
  Array<Stop> stops(placed.size() + 1);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    stops[i].p = placed[i].p;
    place_of[placed[i].stop] = static_cast<std::uint32_t>(i);
  }
  for (FoundBound& b : found.bounds()) b.rank = stops[place_of[b.start] + 1].bounds_begin++;
  for (std::size_t i = 1; i < stops.size(); ++i) stops[i].bounds_begin += stops[i - 1].bounds_begin;
  return stops;
}

}  // namespace

Bounds find_bounds(const ChainGraph& graph, std::span<const std::uint32_t> chains) {
  Finder found(graph, chains.size());
  Steps steps(chains.size());
  for (const std::uint32_t c : chains) {
    steps();
    found.add(c);
  }
  Array<std::uint32_t> place_of;
  Bounds result;
  result.stops = order_stops(found, place_of);

  // Step 3: moves bounds to their places.
  result.bounds.resize(found.bounds().size());
  for_ranges(found.bounds().size(), tuning::bounds_a_task, [&](std::size_t first, std::size_t past) {
    for (std::size_t i = first; i < past; ++i) {
      const FoundBound& b = found.bounds()[i];
      const std::uint32_t at = result.stops[place_of[b.start]].bounds_begin + b.rank;
      const Winding change = graph.chains[b.chain].change;
      const bool rightward = b.first < b.last;
      result.bounds[at] = {graph.point(rightward ? b.first + 1 : b.first - 1),
                           b.first,
                           b.last,
                           b.chain,
                           place_of[b.top],
                           rightward ? change : -change};
    }
  });

  // Step 4: sorts the bounds of each stop from bottom to top.
  for_ranges(result.stop_count(), tuning::bounds_a_task, [&](std::size_t first, std::size_t past) {
    for (std::size_t s = first; s < past; ++s) {
      const auto begin = result.bounds.begin() + result.stops[s].bounds_begin;
      const auto end = result.bounds.begin() + result.stops[s + 1].bounds_begin;
      if (end - begin < 2) continue;
      const Point& p = result.stops[s].p;
      std::sort(begin, end,
                [&](const Bound& r, const Bound& t) { return exact::orientation(p, r.second, t.second) > 0; });
    }
  });
  return result;
}

}  // namespace oblast::internal::vatti
