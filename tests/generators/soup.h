// Builds contours for the hostile generators.
#pragma once

#include <oblast/region_set.h>

#include <vector>

#include "generators/random.h"

namespace oblast::generators {

using Ring = std::vector<Point>;

/// Add `ring` to `soup`, as a polygon or as a further contour of the last polygon.
/// Coordinates smaller than the domain's smallest become 0. Rings may have any number of vertices.
void add_polygon(RegionSet& soup, const Ring& ring);
void add_hole(RegionSet& soup, const Ring& ring);

/// Adds `ring` in one of the two ways; one in three becomes a further contour of the last polygon.
void add_either_way(RegionSet& soup, const Ring& ring, Random& random);

/// Axis-parallel, counter-clockwise.
Ring rectangle(double x0, double y0, double x1, double y1);

Ring reversed(Ring ring);

/// Moves a coordinate by at most `steps` units in the last place. 0 stays 0.
double nudge(double coordinate, int steps, Random& random);
Ring nudge(Ring ring, int steps, Random& random);

/// A random point of the segment ab, rounded twice: rarely on the segment, always close to it.
Point along(const Point& a, const Point& b, Random& random);

}  // namespace oblast::generators
