#include "overlay/rings.h"

#include <algorithm>

namespace oblast {
namespace {

/// By node: RingVertex bits.
std::vector<std::uint8_t> classify_nodes(const ChainGraph& graph, const Selection& selection) {
  std::vector<std::uint8_t> flags(graph.node_count(), 0);
  std::vector<bool> input_vertex(graph.node_count(), false);
  std::vector<std::uint32_t> degree(graph.node_count(), 0);
  const auto added = [&](std::uint32_t vertex) { return (graph.strands.flags[vertex] & noding::added_flag) != 0; };

  for (const Chain& chain : graph.chains) {
    if (chain.is_loop() || !graph.is_live(chain.merged_into)) continue;
    if (!added(chain.first)) input_vertex[chain.from] = true;
    if (!added(chain.last)) input_vertex[chain.to] = true;
  }
  for (std::uint32_t c = 0; c < selection.size(); ++c) {
    if (selection[c] == none || graph.chains[c].is_loop()) continue;
    ++degree[graph.chains[c].from];
    ++degree[graph.chains[c].to];
  }
  for (std::size_t node = 0; node < flags.size(); ++node)
    if (degree[node] > 2) flags[node] = touch_vertex;

  // Chains that follow one another in a strand at an added vertex are pieces of one input edge.
  for (std::size_t c = 1; c < graph.chains.size(); ++c) {
    const Chain &before = graph.chains[c - 1], &after = graph.chains[c];
    if (before.last != after.first || after.is_loop() || !added(after.first)) continue;
    const std::uint32_t node = after.from;
    const bool both_selected = selection[before.merged_into] != none && selection[after.merged_into] != none;
    if (both_selected && before.merged_into != after.merged_into && degree[node] == 2 && !input_vertex[node])
      flags[node] |= trace_vertex;
  }
  return flags;
}

}  // namespace

Rings contours_to_rings(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked) {
  const std::vector<std::uint8_t> node_flags = classify_nodes(graph, selection);
  Rings rings;
  std::size_t size = 0;
  for (const Descriptor d : linked.descriptors)
    size += graph.chains[chain_of(d)].last - graph.chains[chain_of(d)].first;
  rings.points.reserve(size);
  rings.flags.reserve(size);
  rings.ends.reserve(linked.ends.size());
  for (std::size_t c = 0; c < linked.ends.size(); ++c) {
    for (const Descriptor d : linked.contour(c)) {
      const Chain& chain = graph.chains[chain_of(d)];
      const auto first = graph.strands.points.begin() + chain.first, last = graph.strands.points.begin() + chain.last;
      if (is_backward(d))
        rings.points.insert(rings.points.end(), std::reverse_iterator(last + 1), std::reverse_iterator(first + 1));
      else
        rings.points.insert(rings.points.end(), first, last);
      rings.flags.push_back(chain.is_loop() ? std::uint8_t{0} : node_flags[graph.start_node(d)]);
      rings.flags.resize(rings.points.size(), 0);
    }
    rings.ends.push_back(static_cast<std::uint32_t>(rings.points.size()));
  }
  return rings;
}

}  // namespace oblast
