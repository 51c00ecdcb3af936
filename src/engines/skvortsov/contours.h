// Step 4: polygons from the triangulation (section 3.2).
//
// Walks along the sides between a kept triangle (on their left) and a dropped one give the contours. At a vertex, the
// walk goes around it clockwise, inside the kept triangles, to the next such side:
//
//              \ dropped          along u to x; the triangles between u and w are kept; then along w
//        kept   w
//     ---u-----x        the leftmost turn, so walks never cross
//       dropped
//
// This is the `leonov_nikitin` convention. For `ogc`, a walk is divided where it returns to a vertex. All contours
// around one connected set of kept triangles are one polygon.
#pragma once

#include "base/call_memory.h"
#include "engines/skvortsov/marked_mesh.h"
#include "result/nesting.h"
#include "result/rings.h"

namespace oblast::internal::skvortsov {

/// By triangle: kept in the result or not.
using Kept = Array<bool>;

struct Contours {
  Array<std::uint32_t> vertices;  ///< indices in the mesh; contours one after another
  Array<std::uint32_t> ends;      ///< by contour
  Nesting nesting;
};

/// Cost: O(n) on average. In the worst case, the sum of the degrees of the vertices of all sides of the result.
Contours walk_contours(const triangulation::Mesh& mesh, const Kept& kept, ContourConvention convention);

}  // namespace oblast::internal::skvortsov
