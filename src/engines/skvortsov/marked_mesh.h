// Step 1: a triangulation whose sides store how often each operand runs along them.
#pragma once

#include "base/call_memory.h"
#include "graph/chain_graph.h"
#include "triangulation/mesh.h"

namespace oblast::internal::skvortsov {

struct MarkedMesh {
  triangulation::Mesh mesh;
  Array<Descriptor> mark;     ///< by half-edge: the chain along it, in its direction; none if there is no chain
  Array<std::uint32_t> node;  ///< by vertex: its node in the graph; none inside chains
  Array<triangulation::HalfEdge> first_side;  ///< by chain: the half-edge of its first edge; none if not live
};

/// Every vertex of a live chain becomes a vertex, every edge a constraint. Throws Error(too_large).
/// Cost: that of the triangulation.
MarkedMesh mark_mesh(const ChainGraph& graph);

}  // namespace oblast::internal::skvortsov
