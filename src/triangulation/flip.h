// Lawson's flips in a triangulation with constraints.
#pragma once

#include "base/call_memory.h"
#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

/// Flips sides until each that is not constrained is Delaunay, beginning with the `suspects` (emptied) and
/// going on to the sides around each flip. Keeps `leaving` (by vertex: some half-edge with that origin)
/// right. REQUIRES: no suspect ends at infinity.
void make_delaunay(Mesh& mesh, Array<HalfEdge>& leaving, Array<HalfEdge>& suspects);

}  // namespace oblast::internal::triangulation
