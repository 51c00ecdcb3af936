// The Delaunay triangulation of points, by insertion one by one.
//
// For each point, in spatial order (spatial_order.h): walk to the triangle it lies in, from the last one
// made; part that triangle, or the two at the side it lies on; then flip sides that are not Delaunay
// (Lawson), by an explicit stack. All decisions by exact predicates, so every input is treated alike:
// collinear, cocircular, equal points.
// Measured, processor time of one thread of a busy 2-core EPYC, uniform points: 0.23, 0.28 and 0.36 us a point
// at 10^4, 10^5 and 10^6; beside CGAL 5.5 in one run 2.1 to 3.3 times its rate (bench/triangulation).
#pragma once

#include <span>

#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

/// Any two, one or no points, and points all collinear, give a mesh without triangles (vertex_of is filled).
/// Of cocircular points some triangulation, always the same for the same input. REQUIRES: coordinates
/// in the domain, fewer than 2^29 points. Cost: O(n) on average, once sorted; memory 64 bytes a point.
Mesh delaunay(std::span<const Point> points);

}  // namespace oblast::internal::triangulation
