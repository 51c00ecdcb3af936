#include "check/touches.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/tuning.h"
#include "check/strands_of.h"

namespace oblast::internal::checking {
namespace {

/// One contour that goes through the node: by which vertex.
struct Pass {
  std::size_t contour;
  std::uint32_t vertex;

  friend auto operator<=>(const Pass&, const Pass&) = default;
};

void look_for_passes(const ChainGraph& graph, std::uint32_t node, Array<Pass>& passes, FirstFinding& first) {
  passes.clear();
  for (const Descriptor d : graph.list(node)) {
    if (is_backward(d)) continue;
    const std::uint32_t index = graph.start_vertex(d);
    passes.push_back({graph.strands.strand_of(index), vertex_of(graph.strands, index)});
  }
  std::sort(passes.begin(), passes.end());
  for (std::size_t i = 1; i < passes.size(); ++i)
    if (passes[i].contour == passes[i - 1].contour)
      first.offer(
          {FaultKind::touches_itself, passes[i].vertex, passes[i - 1].vertex, graph.point(graph.node_vertex[node])});
}

void look_for_sectors(const ChainGraph& graph, std::uint32_t node, FirstFinding& first) {
  const std::span<const Descriptor> list = graph.list(node);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (is_backward(list[i])) continue;
    const Descriptor after = list[i + 1 < list.size() ? i + 1 : 0];
    const std::uint32_t vertex = vertex_of(graph.strands, graph.start_vertex(list[i]));
    const std::uint32_t other = vertex_of(graph.strands, graph.start_vertex(after));
    if (!is_backward(after) || vertex != other)
      first.offer({FaultKind::touches_itself, vertex, other, graph.point(graph.node_vertex[node])});
  }
}

}  // namespace

std::optional<Finding> find_bad_touch(const ChainGraph& graph, ContourConvention convention) {
  FirstFinding first;
  for_ranges(graph.node_count(), tuning::listed_nodes_a_range, [&](std::size_t begin, std::size_t end) {
    Array<Pass> passes;
    for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
      if (convention == ContourConvention::ogc)
        look_for_passes(graph, node, passes, first);
      else
        look_for_sectors(graph, node, first);
    }
  });
  return first.get();
}

}  // namespace oblast::internal::checking
