// Checks a buffer zone against references of its own making: the whole plane, exactly, for few edges.
//
// The sum (Minkowski) of a convex shape and a polygon within the disc is inside of the true zone, that of a polygon
// around the disc holds it. So the zone must hold the regions and all sums of their edges, of lines and of points with
// an octagon within the disc of the lower bound, and lie in the sums with an octagon around the disc of the upper one.
// A lost loop, a filled hole, a wrong part of any size is found, wherever it is.
#pragma once

#include <optional>

#include "verify/buffer_zone.h"

namespace oblast::verify {

/// The first place where the zone breaks its references. REQUIRES: round joins and caps on both sides; `shapes` as in
/// check_zone. Says nothing if the lower bound is within a million units in the last place of the largest coordinate.
/// Cost: O(n^2) trapezoids of exact numbers, n the edges of the zone and 20 for each edge of the shapes; made for less
/// than about 20 of these.
std::optional<Fault> check_references(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds);

/// The same for a zone of negative distance.
std::optional<Fault> check_inner_references(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds);

}  // namespace oblast::verify
