// Inserts constraints into a Delaunay triangulation: the sides of polygons become sides of triangles.
//
// A constraint that is not yet a side crosses some sides. Their triangles are removed, and the pockets on both sides of
// the constraint are filled with new triangles (pocket.h). Then Lawson's flips make the triangles Delaunay, as far as
// the constraints allow (flip.h). All decisions are exact, and there is no recursion.
#pragma once

#include <span>

#include "base/call_memory.h"
#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

/// A side from one vertex of the mesh to another.
struct Constraint {
  std::uint32_t from;
  std::uint32_t to;
};

/// Makes the constraints sides of `mesh`. Returns, for each constraint, the half-edge in its direction. Constraints may
/// repeat. REQUIRES: `from` and `to` differ; the mesh has triangles. Throws Error(precondition) if constraints meet
/// other than at ends, or if a vertex lies inside one. Cost: linear in the numbers of constraints, of sides that they
/// cross, and of flips (on average about as many).
Array<HalfEdge> constrain(Mesh& mesh, std::span<const Constraint> constraints);

}  // namespace oblast::internal::triangulation
