#include "overlay/rings.h"

#include <algorithm>
#include <numeric>

#include "memory/large_pages.h"
#include "parallel/for_ranges.h"

namespace oblast {
namespace {

/// Writes the vertices of a contour to points and flags from `vertex` on.
void write_ring(const ChainGraph& graph, const std::vector<std::uint8_t>& node_flags,
                std::span<const Descriptor> contour, std::uint32_t vertex, Rings& rings) {
  for (const Descriptor d : contour) {
    const Chain& chain = graph.chains[chain_of(d)];
    const auto first = graph.strands.points.begin() + chain.first, last = graph.strands.points.begin() + chain.last;
    const auto to = rings.points.begin() + vertex;
    if (is_backward(d))
      std::copy(std::reverse_iterator(last + 1), std::reverse_iterator(first + 1), to);
    else
      std::copy(first, last, to);
    if (!chain.is_loop()) rings.flags[vertex] = node_flags[graph.start_node(d)];
    vertex += chain.last - chain.first;
  }
}

}  // namespace

Rings contours_to_rings(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked) {
  const std::vector<std::uint8_t> node_flags = classify_nodes(graph, selection);
  Rings rings;
  constexpr std::size_t contours_a_task = 2048;
  rings.ends.resize(linked.ends.size());
  for_ranges(rings.size(), contours_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      for (const Descriptor d : linked.contour(c))
        rings.ends[c] += graph.chains[chain_of(d)].last - graph.chains[chain_of(d)].first;
    }
  });
  std::partial_sum(rings.ends.begin(), rings.ends.end(), rings.ends.begin());
  const std::uint32_t size = rings.ends.empty() ? 0 : rings.ends.back();
  resize_in_large_pages(rings.points, size);
  rings.flags.resize(size, 0);
  for_ranges(rings.size(), contours_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) write_ring(graph, node_flags, linked.contour(c), rings.begin(c), rings);
  });
  return rings;
}

}  // namespace oblast
