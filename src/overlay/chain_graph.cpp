// Where a strand has a node it stops: its first vertex, its last, and every one flagged in between.
//
//   strand     s0 ------- s1 ------- s2          stops, numbered through all strands
//              [ chain 0  ][ chain 1 ]           a chain runs from a stop to the next one of its strand
//
// Stops at one place are one node. They are brought together by sorting along a curve, so nodes that are near in the
// plane are near in memory, which is what every later walk over the graph is quick by.
#include "overlay/chain_graph.h"

#include <algorithm>
#include <atomic>

#include "memory/large_pages.h"
#include "noding/curve_order.h"
#include "overlay/angular_order.h"
#include "parallel/for_ranges.h"

namespace oblast {
namespace {

using noding::Strands;

struct Stops {
  LargeArray<std::uint32_t> vertex;  ///< by stop
  LargeArray<std::uint32_t> chain;   ///< by stop: the chain that starts here; none at the end of a strand
  LargeArray<std::uint32_t> node;    ///< by stop
  LargeArray<noding::Keyed> order;   ///< stops, node by node; the key is 1 where a node begins, else 0
  LargeArray<std::uint32_t> ends;    ///< by node: past its last stop in `order`

  bool has_chain_before(std::uint32_t stop) const { return stop > 0 && chain[stop - 1] != none; }
  bool has_chain_after(std::uint32_t stop) const { return chain[stop] != none; }
  std::uint32_t degree(std::uint32_t stop) const { return has_chain_before(stop) + has_chain_after(stop); }
};

/// Steps 1 and 3: where strands stop, and the chains between. By ranges of vertices: first what each has, then where to
/// put it is known.
class ChainCutter {
 public:
  explicit ChainCutter(const Strands& strands)
      : strands_(strands), ranges_(range_count(strands.points.size(), vertices_a_range) + 1) {}

  Stops stops() {
    for_numbered_ranges(
        strands_.points.size(), vertices_a_range,
        [&](std::size_t i, std::size_t begin, std::size_t end) { ranges_[i + 1] = counted(begin, end); });
    for (std::size_t i = 1; i < ranges_.size(); ++i) ranges_[i].add(ranges_[i - 1]);
    Stops stops;
    resize_in_large_pages(stops.vertex, ranges_.back().stops);
    resize_in_large_pages(stops.chain, ranges_.back().stops);
    for_numbered_ranges(
        strands_.points.size(), vertices_a_range,
        [&](std::size_t i, std::size_t begin, std::size_t end) { stop(begin, end, ranges_[i], stops); });
    return stops;
  }

  /// Once the stops have their nodes.
  LargeArray<Chain> chains(const Stops& stops) const {
    LargeArray<Chain> chains;
    resize_in_large_pages(chains, ranges_.back().chains);
    for_numbered_ranges(
        strands_.points.size(), vertices_a_range,
        [&](std::size_t i, std::size_t begin, std::size_t end) { cut(begin, end, ranges_[i], stops, chains); });
    return chains;
  }

 private:
  static constexpr std::size_t vertices_a_range = 1 << 16;

  /// How many stops and chains come before a range, and the last stop's vertex. Chains count where they end.
  struct Range {
    std::uint32_t stops = 0, chains = 0, last_stop = 0;

    void add(const Range& before) {
      if (stops == 0) last_stop = before.last_stop;
      stops += before.stops;
      chains += before.chains;
    }
  };

  bool is_node(std::uint32_t v) const { return (strands_.flags[v] & noding::node_flag) != 0; }

  /// Calls stop(strand, vertex) for what of nodes is in [begin, end), and loop(strand) for contours without nodes that
  /// begin there.
  template <class Stop, class Loop>
  void walk(std::size_t begin, std::size_t end, const Stop& stop, const Loop& loop) const {
    auto v = static_cast<std::uint32_t>(begin);
    for (std::size_t s = strands_.strand_of(v); v < end; ++s) {
      const std::uint32_t first = strands_.begin(s);
      const auto past = static_cast<std::uint32_t>(std::min<std::size_t>(strands_.ends[s], end));
      if (!is_node(first)) {
        if (v == first) loop(s);
        v = past;
      }
      for (; v < past; ++v)
        if (is_node(v)) stop(s, v);
    }
  }

  Range counted(std::size_t begin, std::size_t end) const {
    Range range;
    walk(
        begin, end,
        [&](std::size_t s, std::uint32_t v) {
          ++range.stops;
          range.chains += v != strands_.begin(s);
          range.last_stop = v;
        },
        [&](std::size_t) { ++range.chains; });
    return range;
  }

  void stop(std::size_t begin, std::size_t end, Range before, Stops& stops) const {
    walk(
        begin, end,
        [&](std::size_t s, std::uint32_t v) {
          before.chains += v != strands_.begin(s);
          stops.vertex[before.stops] = v;
          stops.chain[before.stops] = v + 1 == strands_.ends[s] ? none : before.chains;
          ++before.stops;
        },
        [&](std::size_t) { ++before.chains; });
  }

  void cut(std::size_t begin, std::size_t end, Range before, const Stops& stops, LargeArray<Chain>& chains) const {
    const auto add = [&](std::uint32_t first, std::uint32_t last, std::uint32_t from, std::uint32_t to, std::size_t s) {
      chains[before.chains] = {first, last, from, to, before.chains, strands_.change[s]};
      ++before.chains;
    };
    walk(
        begin, end,
        [&](std::size_t s, std::uint32_t v) {
          const std::uint32_t stop = before.stops++;
          if (v != strands_.begin(s)) add(before.last_stop, v, stops.node[stop - 1], stops.node[stop], s);
          before.last_stop = v;
        },
        [&](std::size_t s) { add(strands_.begin(s), strands_.ends[s] - 1, none, none, s); });
  }

  const Strands& strands_;
  Array<Range> ranges_;
};

constexpr std::size_t stops_a_task = 32768;

/// A range of stops in order that holds whole nodes.
struct NodeRange {
  std::size_t begin;
  std::uint32_t first_node = 0, first_list = 0;  ///< how many nodes, and entries of lists, come before
};

/// Step 2a: puts the stops in order. Of the ranges the last one is past all.
Array<NodeRange> order_stops(const Strands& strands, Stops& stops) {
  LargeArray<Point> places;
  resize_in_large_pages(places, stops.vertex.size());
  for_ranges(places.size(), stops_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) places[k] = strands.points[stops.vertex[k]];
  });
  stops.order = noding::curve_order(places);
  auto& order = stops.order;
  const auto in_order = [&](const noding::Keyed& p, const noding::Keyed& q) {
    const Point &p_place = places[p.index], &q_place = places[q.index];
    return p_place != q_place ? lexicographically_less(p_place, q_place) : p.index < q.index;
  };
  // Ranges of whole keys: stops of one key are sorted together, and stops at one place are among them.
  Array<NodeRange> ranges;
  ranges.reserve(order.size() / stops_a_task + 2);
  ranges.push_back({0});
  for (std::size_t i = stops_a_task; i < order.size(); i += stops_a_task) {
    while (i < order.size() && order[i].key == order[i - 1].key) ++i;
    ranges.push_back({i});
  }
  ranges.push_back({order.size()});
  for_ranges(ranges.size() - 1, 1, [&](std::size_t range, std::size_t past) {
    for (; range < past; ++range) {
      std::uint32_t nodes = 0, listed = 0;
      for (std::size_t first = ranges[range].begin, last; first < ranges[range + 1].begin; first = last) {
        for (last = first + 1; last < ranges[range + 1].begin && order[last].key == order[first].key; ++last) continue;
        if (last - first > 1) std::sort(order.data() + first, order.data() + last, in_order);
        for (std::size_t i = first; i < last; ++i) {
          order[i].key = i == first || places[order[i].index] != places[order[i - 1].index];
          nodes += order[i].key;
          listed += stops.degree(order[i].index);
        }
      }
      // Summed up below.
      ranges[range + 1].first_node = nodes;
      ranges[range + 1].first_list = listed;
    }
  });
  for (std::size_t range = 1; range < ranges.size(); ++range) {
    ranges[range].first_node += ranges[range - 1].first_node;
    ranges[range].first_list += ranges[range - 1].first_list;
  }
  return ranges;
}

/// Step 2b: the nodes, and room for their lists.
void number_nodes(std::span<const NodeRange> ranges, Stops& stops, ChainGraph& graph) {
  const std::uint32_t node_count = ranges.back().first_node;
  resize_in_large_pages(stops.node, stops.vertex.size());
  resize_in_large_pages(stops.ends, node_count);
  resize_in_large_pages(graph.node_vertex, node_count);
  resize_in_large_pages(graph.list_ends, node_count);
  for_ranges(ranges.size() - 1, 1, [&](std::size_t range, std::size_t past) {
    for (; range < past; ++range) {
      std::uint32_t next_node = ranges[range].first_node, list_end = ranges[range].first_list;
      for (std::size_t i = ranges[range].begin; i < ranges[range + 1].begin; ++i) {
        const std::uint32_t stop = stops.order[i].index;
        if (stops.order[i].key == 1) graph.node_vertex[next_node++] = stops.vertex[stop];
        const std::uint32_t node = next_node - 1;
        list_end += stops.degree(stop);
        graph.list_ends[node] = list_end;
        stops.ends[node] = static_cast<std::uint32_t>(i + 1);
        stops.node[stop] = node;
      }
    }
  });
}

/// A descriptor with the point it aims at, so that sorting by angle finds it at hand.
struct Aimed {
  Point at;
  Descriptor descriptor;
};

/// Descriptors with the same direction from a node are chains of one edge with the same ends: longer ones cannot
/// coincide, since every vertex of theirs would be a node. They become one chain, with the sum of the changes.
void merge_coincident_chains(ChainGraph& graph, std::span<const Aimed> coincident) {
  const auto by_chain = [](const Aimed& p, const Aimed& q) { return p.descriptor < q.descriptor; };
  const Descriptor kept = std::min_element(coincident.begin(), coincident.end(), by_chain)->descriptor;
  Winding change;
  for (const Aimed& aimed : coincident) {
    change = change + graph.change(aimed.descriptor);
    graph.chains[chain_of(aimed.descriptor)].merged_into = chain_of(kept);
  }
  graph.chains[chain_of(kept)].change = graph.strands.parity.reduce(is_backward(kept) ? -change : change);
}

void sort_by_angle(const Point& x, Array<Aimed>& list) {
  std::sort(list.begin(), list.end(), [&](const Aimed& p, const Aimed& q) { return angularly_less(x, p.at, q.at); });
}

/// Step 4: the connectivity lists L(x), each sorted by angle. True when chains were merged.
bool build_connectivity_lists(ChainGraph& graph, const Stops& stops) {
  resize_in_large_pages(graph.lists, graph.list_ends.empty() ? 0 : graph.list_ends.back());
  std::atomic<bool> merged = false;
  constexpr std::size_t nodes_a_task = 8192;
  for_ranges(graph.node_count(), nodes_a_task, [&](std::size_t begin, std::size_t end) {
    Array<Aimed> list;
    list.reserve(16);
    for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
      list.clear();
      for (std::uint32_t i = node == 0 ? 0 : stops.ends[node - 1]; i < stops.ends[node]; ++i) {
        const std::uint32_t stop = stops.order[i].index, vertex = stops.vertex[stop];
        if (stops.has_chain_before(stop))
          list.push_back({graph.point(vertex - 1), opposite(forward(stops.chain[stop - 1]))});
        if (stops.has_chain_after(stop)) list.push_back({graph.point(vertex + 1), forward(stops.chain[stop])});
      }
      sort_by_angle(graph.point(graph.node_vertex[node]), list);
      std::uint32_t place = node == 0 ? 0 : graph.list_ends[node - 1];
      for (const Aimed& aimed : list) graph.lists[place++] = aimed.descriptor;
      for (std::size_t first = 0, last; first < list.size(); first = last) {
        for (last = first + 1; last < list.size() && list[last].at == list[first].at; ++last) continue;
        // Both ends see it; one of them does it.
        if (last - first == 1 || graph.end_node(list[first].descriptor) < node) continue;
        merge_coincident_chains(graph, std::span(list).subspan(first, last - first));
        merged.store(true, std::memory_order_relaxed);
      }
    }
  });
  return merged;
}

/// Step 5: takes chains that are not live out of the lists.
void drop_dead_chains(ChainGraph& graph) {
  // Each range of nodes packs its lists at their beginning; then the ranges are moved together.
  struct Range {
    std::uint32_t begin = 0, kept = 0, before = 0;
  };
  constexpr std::size_t nodes_a_range = 1 << 14;
  Array<Range> ranges(range_count(graph.node_count(), nodes_a_range));
  for (std::size_t range = 1; range < ranges.size(); ++range)
    ranges[range].begin = graph.list_ends[range * nodes_a_range - 1];
  for_numbered_ranges(graph.node_count(), nodes_a_range, [&](std::size_t range, std::size_t first, std::size_t past) {
    std::uint32_t begin = ranges[range].begin, kept = begin;
    for (std::size_t node = first; node < past; ++node) {
      const std::uint32_t end = graph.list_ends[node];
      for (std::uint32_t i = begin; i < end; ++i)
        if (graph.is_live(chain_of(graph.lists[i]))) graph.lists[kept++] = graph.lists[i];
      begin = end;
      graph.list_ends[node] = kept - ranges[range].begin;
    }
    ranges[range].kept = kept - ranges[range].begin;
  });
  std::uint32_t size = 0;
  for (Range& range : ranges) {
    const auto first = graph.lists.begin() + range.begin;
    if (size != range.begin) std::copy(first, first + range.kept, graph.lists.begin() + size);
    range.before = size;
    size += range.kept;
  }
  graph.lists.resize(size);
  for_numbered_ranges(graph.node_count(), nodes_a_range, [&](std::size_t range, std::size_t first, std::size_t past) {
    for (std::size_t node = first; node < past; ++node) graph.list_ends[node] += ranges[range].before;
  });
}

}  // namespace

ChainGraph build_chain_graph(Strands strands) {
  ChainGraph graph;
  graph.strands = std::move(strands);
  ChainCutter cutter(graph.strands);
  Stops stops = cutter.stops();
  number_nodes(order_stops(graph.strands, stops), stops, graph);
  graph.chains = cutter.chains(stops);
  stops.node = LargeArray<std::uint32_t>();
  if (build_connectivity_lists(graph, stops)) drop_dead_chains(graph);
  return graph;
}

}  // namespace oblast
