// Contours of every kind the classics admit or refuse.
#pragma once

#include <oblast/region_set.h>

#include <vector>

#include "classics/cases.h"

namespace oblast::tests {

/// A rectangle as a region, counter-clockwise.
RegionSet rectangle(double x0, double y0, double x1, double y1);

/// Convex, counter-clockwise, three or more vertices, some of them straight.
std::vector<Point> convex(Plane& plane);
/// Simple, of about n vertices.
std::vector<Point> simple(Plane& plane, int n);
/// Any closed contour of n vertices.
std::vector<Point> tangle(Plane& plane, int n);
/// Edges disjoint, or meeting at their ends, or coinciding: a walk along edges of a triangulated grid.
std::vector<Point> vertex_complete(Plane& plane);
/// A ring with one to three holes, drawn as one contour with a bridge to each hole, walked there and back.
std::vector<Point> keyhole(Plane& plane);

/// The corners of a rectangle, counter-clockwise.
std::vector<Point> rectangle(Plane& plane, int x0, int y0, int x1, int y1);
/// Rectangles in and beside each other that do not meet, dealt out to one to three polygons, in any order and
/// direction.
RegionSet nested(Plane& plane);

// Outside some domain:
std::vector<Point> notched(Plane& plane);            ///< simple, one vertex turns the other way
std::vector<Point> wound_twice(Plane& plane);        ///< turns one way only, twice round
std::vector<Point> crossed(Plane& plane);            ///< two edges cross
std::vector<Point> overlapping_edges(Plane& plane);  ///< two edges share a part, not the whole
RegionSet two_that_overlap(Plane& plane);            ///< two polygons whose boundaries cross
RegionSet hole_directed_wrongly(Plane& plane);
RegionSet vertex_on_own_edge(Plane& plane);

}  // namespace oblast::tests
