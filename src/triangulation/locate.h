// Finds the triangle that contains a point, by walking.
#pragma once

#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

/// The place of a point: strictly inside a triangle (for a ghost: strictly beyond its side of the hull), on a side, or
/// at a vertex.
struct Place {
  enum class Kind { inside, on_side, at_vertex };
  Kind kind;
  HalfEdge half_edge;  ///< inside: any of the triangle; on_side: that side; at_vertex: one that leaves it
};

/// Walks from the triangle `start`, at each step across a side that has p strictly on its right. In a Delaunay
/// triangulation such a walk has no cycle: the power of p with respect to the circles decreases, and among triangles of
/// one circle there is no cycle either. REQUIRES: the triangulation is Delaunay, without constraints. Cost: linear in
/// the number of triangles on the walk.
Place locate(const Mesh& mesh, std::uint32_t start, const Point& p);

}  // namespace oblast::internal::triangulation
