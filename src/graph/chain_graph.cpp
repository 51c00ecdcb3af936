// Where a strand has a node it stops: its first vertex, its last, and every one flagged in between.
//
//   strand     s0 ------- s1 ------- s2          stops, numbered through all strands
//              [ chain 7  ][ chain 3 ]           a chain runs from a stop to the next one of its strand
//
// Stops at one place are one node. They are brought together by sorting along a curve, so nodes that are near in the
// plane are near in memory, and so are the chains, which are numbered by the nodes they leave: this is what every later
// walk over the graph is quick by.
#include "graph/chain_graph.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/fetch.h"
#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "graph/angular_order.h"
#include "plane/curve_order.h"

namespace oblast::internal {
namespace {

using noding::Strands;

struct Stop {
  std::uint32_t vertex;
  std::uint32_t strand;
  std::uint32_t node;
  std::uint32_t chain;  ///< that starts here, if one does
};

struct Stops {
  LargeArray<Stop> along;           ///< along the strands
  LargeArray<Keyed> order;          ///< stops, node by node; the key is 1 where a node begins, else 0
  LargeArray<std::uint32_t> ends;   ///< by node: past its last stop in `order`
  LargeArray<std::uint32_t> loops;  ///< strands that do not stop: contours without nodes

  bool has_chain_before(std::uint32_t stop) const { return stop > 0 && has_chain_after(stop - 1); }
  bool has_chain_after(std::uint32_t stop) const {
    return stop + 1 < along.size() && along[stop].strand == along[stop + 1].strand;
  }
  std::uint32_t degree(std::uint32_t stop) const { return has_chain_before(stop) + has_chain_after(stop); }

  /// Stops are looked at node by node, so they come from all over the strands. Those from `past` on may be in work on
  /// another thread.
  void fetch_ahead(std::size_t i, std::size_t past) const {
    if (i + fetched_ahead < past) fetch_around(along, order[i + fetched_ahead].index);
  }
};

/// Step 1: where strands stop. By ranges of vertices: first what each has, then where to put it is known.
class StopFinder {
 public:
  explicit StopFinder(const Strands& strands)
      : strands_(strands), ranges_(range_count(strands.points.size(), tuning::stop_vertices_a_range) + 1) {}

  /// Without nodes and chains.
  Stops run() {
    for_numbered_ranges(
        strands_.points.size(), tuning::stop_vertices_a_range,
        [&](std::size_t i, std::size_t begin, std::size_t end) { ranges_[i + 1] = counted(begin, end); });
    for (std::size_t i = 1; i < ranges_.size(); ++i) {
      ranges_[i].stops += ranges_[i - 1].stops;
      ranges_[i].loops += ranges_[i - 1].loops;
    }
    Stops stops;
    resize_uninitialized(stops.along, ranges_.back().stops);
    resize_uninitialized(stops.loops, ranges_.back().loops);
    for_numbered_ranges(
        strands_.points.size(), tuning::stop_vertices_a_range,
        [&](std::size_t i, std::size_t begin, std::size_t end) { write(begin, end, ranges_[i], stops); });
    return stops;
  }

 private:
  /// How many come before a range.
  struct Range {
    std::uint32_t stops = 0, loops = 0;
  };

  bool is_node(std::uint32_t v) const { return (strands_.flags[v] & noding::node_flag) != 0; }

  /// Calls visit(strand, first, past) for the vertices of each strand that are in [begin, end).
  template <class Visit>
  void for_each_strand(std::size_t begin, std::size_t end, const Visit& visit) const {
    auto v = static_cast<std::uint32_t>(begin);
    for (std::size_t s = strands_.strand_of(v); v < end; ++s) {
      const auto past = static_cast<std::uint32_t>(std::min<std::size_t>(strands_.ends[s], end));
      visit(s, v, past);
      v = past;
    }
  }

  Range counted(std::size_t begin, std::size_t end) const {
    Range range;
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) range.stops += is_node(v);
    for_each_strand(begin, end, [&](std::size_t s, std::uint32_t first, std::uint32_t) {
      range.loops += first == strands_.begin(s) && !is_node(first);
    });
    return range;
  }

  /// Where nodes are is hard to foresee, so a block of vertices is sorted out first, without branches.
  void write(std::size_t begin, std::size_t end, Range before, Stops& stops) const {
    std::array<std::uint32_t, tuning::stop_vertices_a_block> nodes;
    for_each_strand(begin, end, [&](std::size_t s, std::uint32_t v, std::uint32_t past) {
      if (!is_node(strands_.begin(s))) {
        if (v == strands_.begin(s)) stops.loops[before.loops++] = static_cast<std::uint32_t>(s);
        return;
      }
      while (v < past) {
        std::size_t count = 0;
        for (const std::uint32_t block_end = std::min(v + tuning::stop_vertices_a_block, past); v < block_end; ++v) {
          nodes[count] = v;
          count += is_node(v);
        }
        for (std::size_t i = 0; i < count; ++i)
          stops.along[before.stops++] = {nodes[i], static_cast<std::uint32_t>(s), none, none};
      }
    });
  }

  const Strands& strands_;
  Array<Range> ranges_;
};

/// A range of stops in order that holds whole nodes.
struct NodeRange {
  std::size_t begin;
  /// How many nodes, chains that leave them forward, and entries of lists come before.
  std::uint32_t first_node = 0, first_chain = 0, first_list = 0;
};

/// Step 2a: puts the stops in order. Of the ranges the last one is past all.
Array<NodeRange> order_stops(const Strands& strands, Stops& stops) {
  LargeArray<Point> places;
  resize_uninitialized(places, stops.along.size());
  for_ranges(places.size(), tuning::stops_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) places[k] = strands.points[stops.along[k].vertex];
  });
  stops.order = curve_order(places);
  auto& order = stops.order;
  const auto in_order = [&](const Keyed& p, const Keyed& q) {
    const Point &p_place = places[p.index], &q_place = places[q.index];
    return p_place != q_place ? lexicographically_less(p_place, q_place) : p.index < q.index;
  };
  // Ranges of whole keys: stops of one key are sorted together, and stops at one place are among them.
  Array<NodeRange> ranges;
  ranges.reserve(order.size() / tuning::stops_a_task + 2);
  ranges.push_back({0});
  for (std::size_t i = tuning::stops_a_task; i < order.size(); i += tuning::stops_a_task) {
    while (i < order.size() && order[i].key == order[i - 1].key) ++i;
    ranges.push_back({i});
  }
  ranges.push_back({order.size()});
  for_ranges(ranges.size() - 1, 1, [&](std::size_t range, std::size_t past) {
    for (; range < past; ++range) {
      std::uint32_t nodes = 0, chains = 0, listed = 0;
      for (std::size_t first = ranges[range].begin, last; first < ranges[range + 1].begin; first = last) {
        for (last = first + 1; last < ranges[range + 1].begin && order[last].key == order[first].key; ++last) continue;
        if (last - first > 1) std::sort(order.data() + first, order.data() + last, in_order);
        for (std::size_t i = first; i < last; ++i) {
          stops.fetch_ahead(i, ranges[range + 1].begin);
          if (i + fetched_ahead < ranges[range + 1].begin) fetch(&places[order[i + fetched_ahead].index]);
          order[i].key = i == first || places[order[i].index] != places[order[i - 1].index];
          nodes += order[i].key;
          chains += stops.has_chain_after(order[i].index);
          listed += stops.degree(order[i].index);
        }
      }
      // Summed up below.
      ranges[range + 1].first_node = nodes;
      ranges[range + 1].first_chain = chains;
      ranges[range + 1].first_list = listed;
    }
  });
  for (std::size_t range = 1; range < ranges.size(); ++range) {
    ranges[range].first_node += ranges[range - 1].first_node;
    ranges[range].first_chain += ranges[range - 1].first_chain;
    ranges[range].first_list += ranges[range - 1].first_list;
  }
  return ranges;
}

/// Step 2b: the nodes, the numbers of chains, and room for both and for lists.
void number_nodes(std::span<const NodeRange> ranges, Stops& stops, ChainGraph& graph) {
  const auto& [past, node_count, chain_count, list_size] = ranges.back();
  // Lists have two entries a chain, so they fit too.
  check_count(chain_count + stops.loops.size(), "chains", most_chains);
  resize_uninitialized(stops.ends, node_count);
  resize_uninitialized(graph.node_vertex, node_count);
  resize_uninitialized(graph.list_ends, node_count);
  resize_uninitialized(graph.lists, list_size);
  resize_uninitialized(graph.chains, chain_count + stops.loops.size());
  graph.first_loop = chain_count;
  for_ranges(ranges.size() - 1, 1, [&](std::size_t range, std::size_t last_range) {
    for (; range < last_range; ++range) {
      std::uint32_t next_node = ranges[range].first_node, next_chain = ranges[range].first_chain,
                    list_end = ranges[range].first_list;
      for (std::size_t i = ranges[range].begin; i < ranges[range + 1].begin; ++i) {
        stops.fetch_ahead(i, ranges[range + 1].begin);
        const std::uint32_t k = stops.order[i].index;
        Stop& stop = stops.along[k];
        if (stops.order[i].key == 1) graph.node_vertex[next_node++] = stop.vertex;
        stop.node = next_node - 1;
        list_end += stops.degree(k);
        graph.list_ends[stop.node] = list_end;
        stops.ends[stop.node] = static_cast<std::uint32_t>(i + 1);
        if (stops.has_chain_after(k)) stop.chain = next_chain++;
      }
    }
  });
}

/// A descriptor with the point it aims at, so that sorting by angle finds it at hand.
struct Aimed {
  Point at;
  Descriptor descriptor;
  std::uint32_t to;  ///< node it comes to
};

void sort_by_angle(const Point& x, Array<Aimed>& list) {
  std::sort(list.begin(), list.end(), [&](const Aimed& p, const Aimed& q) { return angularly_less(x, p.at, q.at); });
}

/// Puts the descriptors from x in order, without branches, by how many come before each. False where directions are too
/// near each other for that, or too many.
bool place_by_angle(const Point& x, const Array<Aimed>& list, std::span<Descriptor> places) {
  if (list.size() > tuning::most_counted_directions) return false;
  std::array<double, tuning::most_counted_directions> angles;
  std::array<std::uint32_t, tuning::most_counted_directions> before;
  bool clear = true;
  for (std::size_t i = 0; i < list.size(); ++i) {
    angles[i] = rough_angle(x, list[i].at);
    before[i] = 0;
    for (std::size_t j = 0; j < i; ++j) {
      const double ahead = angles[i] - angles[j];
      clear = static_cast<int>(clear) & static_cast<int>(std::fabs(ahead) > rough_angle_error);
      before[i] += ahead > 0;
      before[j] += ahead < 0;
    }
  }
  if (!clear) return false;
  for (std::size_t i = 0; i < list.size(); ++i) places[before[i]] = list[i].descriptor;
  return true;
}

/// Descriptors [first, last) in `lists` of one direction from a node.
struct Coincident {
  std::uint32_t first, last;
};

/// Step 3: the chains and the connectivity lists L(x), each sorted by angle. By range of nodes, what coincides.
Array<Array<Coincident>> build_connectivity_lists(ChainGraph& graph, const Stops& stops) {
  constexpr std::size_t nodes_a_range = tuning::listed_nodes_a_range;
  Array<Array<Coincident>> coincident(range_count(graph.node_count(), nodes_a_range));
  for_numbered_ranges(graph.node_count(), nodes_a_range, [&](std::size_t range, std::size_t begin, std::size_t end) {
    Array<Aimed> list;
    list.reserve(16);
    for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
      list.clear();
      for (std::uint32_t i = node == 0 ? 0 : stops.ends[node - 1]; i < stops.ends[node]; ++i) {
        stops.fetch_ahead(i, stops.order.size());
        if (i + fetched_ahead / 2 < stops.order.size())
          fetch_around(graph.strands.points, stops.along[stops.order[i + fetched_ahead / 2].index].vertex);
        const std::uint32_t k = stops.order[i].index;
        const Stop& stop = stops.along[k];
        std::uint32_t chain_before = none;
        if (stops.has_chain_before(k)) {
          const Stop& previous = stops.along[k - 1];
          chain_before = previous.chain;
          list.push_back({graph.point(stop.vertex - 1), opposite(forward(chain_before)), previous.node});
        }
        if (!stops.has_chain_after(k)) continue;
        const Stop& next = stops.along[k + 1];
        list.push_back({graph.point(stop.vertex + 1), forward(stop.chain), next.node});
        graph.chains[stop.chain] = {
            stop.vertex, next.vertex, node, next.node, chain_before, stop.chain, graph.strands.change[stop.strand]};
      }
      const Point& at = graph.point(graph.node_vertex[node]);
      const std::uint32_t place = node == 0 ? 0 : graph.list_ends[node - 1];
      if (place_by_angle(at, list, std::span(graph.lists).subspan(place, list.size()))) continue;
      sort_by_angle(at, list);
      for (std::uint32_t i = 0; i < list.size(); ++i) graph.lists[place + i] = list[i].descriptor;
      for (std::uint32_t first = 0, last; first < list.size(); first = last) {
        for (last = first + 1; last < list.size() && list[last].at == list[first].at; ++last) continue;
        // Both ends see it; one of them says so.
        if (last - first > 1 && node < list[first].to) coincident[range].push_back({place + first, place + last});
      }
    }
  });
  return coincident;
}

void add_loops(ChainGraph& graph, const LargeArray<std::uint32_t>& loops) {
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    const std::uint32_t strand = loops[i], chain = graph.first_loop + i;
    graph.chains[chain] = {graph.strands.begin(strand), graph.strands.ends[strand] - 1, none, none, none, chain,
                           graph.strands.change[strand]};
  }
}

/// Step 4: descriptors of one direction are chains of one edge with the same ends: longer ones cannot coincide, since
/// every vertex of theirs would be a node. They become one chain, with the sum of the changes.
void merge_coincident_chains(ChainGraph& graph, std::span<const Descriptor> coincident) {
  const Descriptor kept = *std::min_element(coincident.begin(), coincident.end());
  Winding change;
  for (const Descriptor d : coincident) {
    change = change + graph.change(d);
    graph.chains[chain_of(d)].merged_into = chain_of(kept);
  }
  graph.chains[chain_of(kept)].change = graph.strands.parity.reduce(is_backward(kept) ? -change : change);
}

/// True when there were any.
bool merge_coincident_chains(ChainGraph& graph, const Array<Array<Coincident>>& coincident) {
  for_ranges(coincident.size(), 1, [&](std::size_t range, std::size_t past) {
    for (; range < past; ++range)
      for (const auto& [first, last] : coincident[range])
        merge_coincident_chains(graph, std::span(graph.lists).subspan(first, last - first));
  });
  return std::any_of(coincident.begin(), coincident.end(), [](const auto& range) { return !range.empty(); });
}

/// Step 5: takes chains that are not live out of the lists.
void drop_dead_chains(ChainGraph& graph) {
  // Each range of nodes packs its lists at their beginning; then the ranges are moved together.
  struct Range {
    std::uint32_t begin = 0, kept = 0, before = 0;
  };
  constexpr std::size_t nodes_a_range = tuning::packed_nodes_a_range;
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
  Array<Array<Coincident>> coincident;
  {
    Stops stops = StopFinder(graph.strands).run();
    number_nodes(order_stops(graph.strands, stops), stops, graph);
    coincident = build_connectivity_lists(graph, stops);
    add_loops(graph, stops.loops);
  }
  if (merge_coincident_chains(graph, coincident)) drop_dead_chains(graph);
  return graph;
}

}  // namespace oblast::internal
