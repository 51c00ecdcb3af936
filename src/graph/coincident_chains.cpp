#include "graph/coincident_chains.h"

#include <algorithm>
#include <span>

#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {
namespace {

/// Descriptors of one direction are chains of one edge with the same ends: longer ones cannot coincide, since
/// every vertex of theirs would be a node. They become one chain, with the sum of the changes.
void merge_group(ChainGraph& graph, std::span<const Descriptor> coincident) {
  const Descriptor kept = *std::min_element(coincident.begin(), coincident.end());
  Winding change;
  for (const Descriptor d : coincident) {
    change = graph.strands.rules.sum(change, graph.change(d));
    graph.chains[chain_of(d)].merged_into = chain_of(kept);
  }
  graph.chains[chain_of(kept)].change = graph.strands.rules.reduce(is_backward(kept) ? -change : change);
}

}  // namespace

bool merge_coincident_chains(ChainGraph& graph, const Array<Array<Coincident>>& coincident) {
  for_ranges(coincident.size(), 1, [&](std::size_t range, std::size_t past) {
    for (; range < past; ++range)
      for (const auto& [first, last] : coincident[range])
        merge_group(graph, std::span(graph.lists).subspan(first, last - first));
  });
  return std::any_of(coincident.begin(), coincident.end(), [](const auto& range) { return !range.empty(); });
}

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

}  // namespace oblast::internal
