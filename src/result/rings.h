// The contours of the result as points, before they are put in canonical order.
//
// Where rows are overlaid, the borders between nodes come as rings, too, so that traces on them are judged once for all
// rows. Such a path may be open: its last vertex is not joined to its first, and both are nodes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/large_pages.h"
#include "result/link.h"

namespace oblast::internal {

/// Properties of a vertex of the result; a set of bits.
enum RingVertex : std::uint8_t {
  trace_vertex = 1,  ///< noding added it between two pieces of one input edge; to be removed if possible
  touch_vertex = 2,  ///< more than two edges of the result meet here
};

/// A trace vertex (or its node), and an input edge of which both edges of the result there are pieces.
struct TraceEdge {
  std::uint32_t at;
  std::uint32_t edge;

  friend auto operator<=>(const TraceEdge&, const TraceEdge&) = default;
};

/// The elements for one vertex or node. REQUIRES: `all` is sorted.
inline std::span<const TraceEdge> trace_edges_at(std::span<const TraceEdge> all, std::uint32_t at) {
  const auto begin = std::lower_bound(all.begin(), all.end(), TraceEdge{at, 0});
  auto end = begin;
  while (end != all.end() && end->at == at) ++end;
  return {begin, end};
}

struct Rings {
  LargeArray<Point> points;
  Array<std::uint8_t> flags;     ///< by vertex, RingVertex
  Array<std::uint32_t> ends;     ///< by ring: past its last vertex; the first is not repeated
  Array<bool> open;              ///< by ring: it is an open path; empty where all are closed
  Array<TraceEdge> trace_edges;  ///< of all trace vertices, sorted; each has at least one

  std::uint32_t begin(std::size_t ring) const { return ring == 0 ? 0 : ends[ring - 1]; }
  std::size_t size() const { return ends.size(); }
  bool is_open(std::size_t ring) const { return !open.empty() && open[ring]; }
  /// Whether an edge joins the vertex to the one after it.
  bool has_edge_after(std::size_t ring, std::uint32_t vertex) const {
    return vertex + 1 != ends[ring] || !is_open(ring);
  }
  std::uint32_t before(std::size_t ring, std::uint32_t vertex) const {
    return vertex == begin(ring) ? ends[ring] - 1 : vertex - 1;
  }
  std::uint32_t after(std::size_t ring, std::uint32_t vertex) const {
    return vertex + 1 == ends[ring] ? begin(ring) : vertex + 1;
  }
  std::size_t ring_of(std::uint32_t vertex) const {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), vertex) - ends.begin());
  }
};

/// The rings without the vertices for which drop(ring, vertex) is true, and without their trace edges. Cost: linear.
template <class Drop>
Rings without_if(const Rings& rings, const Drop& drop) {
  Rings result;
  result.open = rings.open;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::uint32_t v = rings.begin(r); v < rings.ends[r]; ++v) {
      if (drop(r, v)) continue;
      result.points.push_back(rings.points[v]);
      result.flags.push_back(rings.flags[v]);
    }
    result.ends.push_back(static_cast<std::uint32_t>(result.points.size()));
  }
  return result;
}

/// Properties of the nodes of a graph.
struct NodeKinds {
  Array<std::uint8_t> flags;     ///< by node: RingVertex bits of the vertex there
  Array<TraceEdge> trace_edges;  ///< of all trace nodes, sorted
};

/// Cost: linear in the chains, and O(t log t) for t trace vertices.
NodeKinds classify_nodes(const ChainGraph& graph, const Selection& selection);

/// Gives the rings their trace edges: node_of(vertex) is the node of a trace vertex.
template <class NodeOf>
void add_trace_edges(const NodeKinds& kinds, const NodeOf& node_of, Rings& rings) {
  if (kinds.trace_edges.empty()) return;
  for (std::uint32_t v = 0; v < rings.flags.size(); ++v) {
    if (!(rings.flags[v] & trace_vertex)) continue;
    for (const TraceEdge& edge : trace_edges_at(kinds.trace_edges, node_of(v)))
      rings.trace_edges.push_back({v, edge.edge});
  }
}

/// The points of every contour, with what is known of the nodes. Cost: linear.
Rings contours_to_rings(const ChainGraph& graph, const NodeKinds& kinds, const LinkedContours& linked);
inline Rings contours_to_rings(const ChainGraph& graph, const Selection& selection, const LinkedContours& linked) {
  return contours_to_rings(graph, classify_nodes(graph, selection), linked);
}

}  // namespace oblast::internal
