#include "engines/skvortsov/marked_mesh.h"

#include "base/call.h"
#include "base/call_memory.h"
#include "base/index.h"
#include "triangulation/constrain.h"
#include "triangulation/delaunay.h"

namespace oblast::internal::skvortsov {
namespace {

using namespace triangulation;

/// The edges of all live chains, with each point stored once.
struct Sides {
  Array<Point> points;
  Array<std::uint32_t> node;   ///< by point
  Array<Constraint> edges;     ///< by points
  Array<std::uint32_t> chain;  ///< by edge
};

class SideCollector {
 public:
  explicit SideCollector(const ChainGraph& graph) : graph_(graph), point_of_node_(graph.node_count(), none) {}

  Sides run() {
    Steps steps(graph_.chains.size());
    for (std::uint32_t c = 0; c < graph_.chains.size(); ++c) {
      steps();
      if (graph_.is_live(c)) add_chain(c);
    }
    return std::move(sides_);
  }

 private:
  std::uint32_t add_point(std::uint32_t vertex, std::uint32_t node) {
    check_count(sides_.points.size() + 1, "vertices to triangulate", most_mesh_vertices);
    sides_.points.push_back(graph_.point(vertex));
    sides_.node.push_back(node);
    return static_cast<std::uint32_t>(sides_.points.size() - 1);
  }

  std::uint32_t point_at(std::uint32_t node) {
    if (point_of_node_[node] == none) point_of_node_[node] = add_point(graph_.node_vertex[node], node);
    return point_of_node_[node];
  }

  void add_chain(std::uint32_t c) {
    const Chain& chain = graph_.chains[c];
    const std::uint32_t first = chain.is_loop() ? add_point(chain.first, none) : point_at(chain.from);
    std::uint32_t from = first;
    for (std::uint32_t v = chain.first + 1; v <= chain.last; ++v) {
      std::uint32_t to;
      if (v < chain.last)
        to = add_point(v, none);
      else
        to = chain.is_loop() ? first : point_at(chain.to);
      sides_.edges.push_back({from, to});
      sides_.chain.push_back(c);
      from = to;
    }
  }

  const ChainGraph& graph_;
  Array<std::uint32_t> point_of_node_;
  Sides sides_;
};

}  // namespace

MarkedMesh mark_mesh(const ChainGraph& graph) {
  Sides sides = SideCollector(graph).run();
  MarkedMesh marked;
  marked.mesh = delaunay(sides.points);
  marked.node.assign(marked.mesh.points.size(), none);
  for (std::size_t i = 0; i < sides.points.size(); ++i) marked.node[marked.mesh.vertex_of[i]] = sides.node[i];
  marked.first_side.assign(graph.chains.size(), none);
  marked.mark.assign(4 * marked.mesh.triangles.size(), none);
  if (marked.mesh.triangles.empty()) return marked;

  for (Constraint& edge : sides.edges) edge = {marked.mesh.vertex_of[edge.from], marked.mesh.vertex_of[edge.to]};
  const Array<HalfEdge> half_edges = constrain(marked.mesh, sides.edges);
  Steps steps(half_edges.size());
  for (std::size_t k = 0; k < half_edges.size(); ++k) {
    steps();
    const std::uint32_t chain = sides.chain[k];
    marked.mark[half_edges[k]] = forward(chain);
    marked.mark[marked.mesh.twin(half_edges[k])] = opposite(forward(chain));
    if (marked.first_side[chain] == none) marked.first_side[chain] = half_edges[k];
  }
  return marked;
}

}  // namespace oblast::internal::skvortsov
