#include "graph/chain_graph.h"

#include <utility>

#include "base/index.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "graph/coincident_chains.h"
#include "graph/connectivity_lists.h"
#include "graph/stops.h"

namespace oblast::internal {
namespace {

using noding::Strands;

/// Step 2b: the nodes, the numbers of chains, and room for both and for lists.
void number_nodes(std::span<const NodeRange> ranges, Stops& stops, ChainGraph& graph) {
  const auto& [node_count, chain_count, list_size] = ranges.back().before;
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
      auto [next_node, next_chain, list_end] = ranges[range].before;
      for (std::size_t i = ranges[range].begin; i < ranges[range + 1].begin; ++i) {
        stops.fetch_ahead(i, ranges[range + 1].begin);
        const std::uint32_t k = stops.order[i].index;
        Stop& stop = stops.along[k];
        if (stops.begins_node[i] != 0) graph.node_vertex[next_node++] = stop.vertex;
        stop.node = next_node - 1;
        list_end += stops.degree(k);
        graph.list_ends[stop.node] = list_end;
        stops.ends[stop.node] = static_cast<std::uint32_t>(i + 1);
        if (stops.has_chain_after(k)) stop.chain = next_chain++;
      }
    }
  });
}

void add_loops(ChainGraph& graph, const LargeArray<std::uint32_t>& loops) {
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    const std::uint32_t strand = loops[i], chain = graph.first_loop + i;
    graph.chains[chain] = {graph.strands.begin(strand), graph.strands.ends[strand] - 1, none, none, none, chain,
                           graph.strands.change[strand]};
  }
}

}  // namespace

ChainGraph build_chain_graph(Strands strands) {
  ChainGraph graph;
  graph.strands = std::move(strands);
  Array<Array<Coincident>> coincident;
  {
    Stops stops = find_stops(graph.strands);
    number_nodes(order_stops(graph.strands, stops), stops, graph);
    coincident = build_connectivity_lists(graph, stops);
    add_loops(graph, stops.loops);
  }
  if (merge_coincident_chains(graph, coincident)) drop_dead_chains(graph);
  return graph;
}

}  // namespace oblast::internal
