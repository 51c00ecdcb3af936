// Constraints into a Delaunay triangulation: the sides of polygons become sides of triangles.
//
// A constraint that is no side yet crosses some sides. Their triangles are taken out and the pockets on
// its two sides filled anew (pocket.h); then Lawson's flips make the triangles Delaunay as far as the constraints
// allow (flip.h). Exact, no recursion.
#pragma once

#include <span>

#include "base/call_memory.h"
#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

/// A side from one vertex to another, by vertices of the mesh.
struct Constraint {
  std::uint32_t from;
  std::uint32_t to;
};

/// Makes the constraints sides of `mesh` and gives by constraint the half-edge in its direction.
/// REQUIRES: `from` and `to` differ, the mesh has triangles. Throws Error(precondition) when constraints
/// meet other than at ends or a vertex lies inside one; they may repeat. Cost: linear in the constraints,
/// the sides they cross, and the flips, which on average are about as many.
Array<HalfEdge> constrain(Mesh& mesh, std::span<const Constraint> constraints);

}  // namespace oblast::internal::triangulation
