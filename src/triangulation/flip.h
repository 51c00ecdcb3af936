// Lawson's flips in a triangulation with constraints.
#pragma once

#include "base/call_memory.h"
#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

/// Flips sides until each side without a constraint is Delaunay. Begins with the `suspects` (which are then empty), and
/// continues with the sides around each flip. Updates `leaving` (by vertex: some half-edge with that origin). REQUIRES:
/// no suspect ends at infinity.
void make_delaunay(Mesh& mesh, Array<HalfEdge>& leaving, Array<HalfEdge>& suspects);

}  // namespace oblast::internal::triangulation
