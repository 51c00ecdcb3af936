// Step 4: polygons from the triangulation (section 3.2).
//
// Sides between a kept triangle (on their left) and a dropped one are walked into contours. At a vertex the
// walk goes around it inside the kept triangles, clockwise, to the next such side:
//
//              \ dropped          along u to x; the triangles between u and w are kept; on along w
//        kept   w
//     ---u-----x        the turn as far to the left as there is, so walks never cross
//       dropped
//
// That is the `leonov_nikitin` convention; for `ogc` a walk is parted where it returns to a vertex. All
// contours around one connected set of kept triangles are one polygon.
#pragma once

#include "base/call_memory.h"
#include "engines/skvortsov/marked_mesh.h"
#include "result/nesting.h"
#include "result/rings.h"

namespace oblast::internal::skvortsov {

/// By triangle: kept in the result or not.
using Kept = Array<bool>;

struct Contours {
  Array<std::uint32_t> vertices;  ///< by the mesh; contours one after the other
  Array<std::uint32_t> ends;      ///< by contour
  Nesting nesting;
};

/// Cost: O(n) on average (the sum over the result's sides of the degrees of their vertices at worst).
Contours walk_contours(const triangulation::Mesh& mesh, const Kept& kept, ContourConvention convention);

}  // namespace oblast::internal::skvortsov
