// The Delaunay triangulation of points: one batch of growing_delaunay.h.
//
// Measured, processor time of one thread of a busy 2-core EPYC, uniform points: 0.23, 0.28 and 0.36 us per point at
// 10^4, 10^5 and 10^6. That is 2.1 to 3.3 times the rate of CGAL 5.5 in the same run (bench/triangulation).
#pragma once

#include <span>

#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

/// Fewer than three points, and collinear points, give a mesh without triangles (vertex_of is filled). For cocircular
/// points it is one of the possible triangulations, always the same for the same input. REQUIRES: coordinates in the
/// domain, fewer than 2^29 points. Cost: O(n) on average after sorting; 64 bytes of memory per point.
Mesh delaunay(std::span<const Point> points);

}  // namespace oblast::internal::triangulation
