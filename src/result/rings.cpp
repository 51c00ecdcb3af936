#include "result/rings.h"

#include <algorithm>
#include <numeric>

#include "base/fetch.h"
#include "base/large_pages.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {
namespace {

/// Writes the vertices of a chain, except the last one, to points and flags, beginning at `vertex`.
void write_chain(const ChainGraph& graph, const Array<std::uint8_t>& node_flags, Descriptor d, std::uint32_t vertex,
                 Rings& rings) {
  const Chain& chain = graph.chains[chain_of(d)];
  const auto first = graph.strands.points.begin() + chain.first, last = graph.strands.points.begin() + chain.last;
  const auto to = rings.points.begin() + vertex;
  // If many edges meet, nearly all chains have one edge.
  if (last - first == 1)
    *to = is_backward(d) ? *last : *first;
  else if (is_backward(d))
    std::copy(std::reverse_iterator(last + 1), std::reverse_iterator(first + 1), to);
  else
    std::copy(first, last, to);
  if (!chain.is_loop()) rings.flags[vertex] = node_flags[graph.start_node(d)];
}

}  // namespace

Rings contours_to_rings(const ChainGraph& graph, const NodeKinds& kinds, const LinkedContours& linked) {
  const Array<Descriptor>& descriptors = linked.descriptors;
  LargeArray<std::uint32_t> ends;  // by descriptor: past its vertices in the rings
  resize_uninitialized(ends, descriptors.size());
  for_ranges(ends.size(), tuning::ring_chains_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Chain& chain = graph.chains[chain_of(descriptors[i])];
      ends[i] = chain.last - chain.first;
    }
  });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  Rings rings;
  rings.ends.reserve(linked.ends.size());
  for (const std::uint32_t end : linked.ends) rings.ends.push_back(ends[end - 1]);
  resize_uninitialized(rings.points, ends.empty() ? 0 : ends.back());
  rings.flags.resize(rings.points.size(), 0);
  for_ranges(ends.size(), grain(ends.size(), rings.points.size()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + fetched_ahead < end) fetch(&graph.chains[chain_of(descriptors[i + fetched_ahead])]);
      if (i + fetched_ahead / 2 < end)
        fetch(&graph.point(graph.chains[chain_of(descriptors[i + fetched_ahead / 2])].first));
      write_chain(graph, kinds.flags, descriptors[i], i == 0 ? 0 : ends[i - 1], rings);
    }
  });
  // Vertices are in the order of the descriptors, and each trace vertex is the beginning of a descriptor.
  std::size_t at = 0;
  const auto node_of = [&](std::uint32_t v) {
    while ((at == 0 ? 0 : ends[at - 1]) < v) ++at;
    return graph.start_node(descriptors[at]);
  };
  add_trace_edges(kinds, node_of, rings);
  return rings;
}

}  // namespace oblast::internal
