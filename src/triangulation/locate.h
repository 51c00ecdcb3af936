// Which triangle a point lies in, by walking.
#pragma once

#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

/// Where a point lies: strictly inside a triangle (for a ghost: strictly beyond its hull side), on a side,
/// or at a vertex.
struct Place {
  enum class Kind { inside, on_side, at_vertex };
  Kind kind;
  HalfEdge half_edge;  ///< inside: any of the triangle; on_side: that side; at_vertex: one that leaves it
};

/// Walks from the triangle `start`, at each step across a side that has p strictly on its right. In a Delaunay
/// triangulation such a walk cannot come round: the power of p with respect to the circles falls, and
/// among triangles of one circle there is no way round either. REQUIRES: Delaunay without constraints.
/// Cost: linear in the triangles walked through.
Place locate(const Mesh& mesh, std::uint32_t start, const Point& p);

}  // namespace oblast::internal::triangulation
