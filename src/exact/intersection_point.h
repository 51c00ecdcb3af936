// The intersection of two edges: the exact rational point, each coordinate rounded to nearest.
#pragma once

#include <oblast/point.h>

namespace oblast::internal::exact {

/// The point where the lines (a, b) and (c, d) meet, each coordinate the nearest double to the exact
/// value, ties to even; a magnitude below the domain becomes 0 or domain_smallest, whichever is
/// nearer. As a function of the exact point it has the same bits for either order of the edges and
/// either direction of each, and it lies in the box of both edges, since rounding is monotone.
/// REQUIRES: the edges meet in one point: orientation decides so before.
Point intersection_point(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace oblast::internal::exact
