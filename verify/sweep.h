// Planarity and topology by one sweep.
#pragma once

#include <optional>

#include "verify/edges.h"

namespace oblast::verify {

/// Finds edges that meet other than at common end points, polygons that overlap, interiors on the wrong side of a
/// contour, and polygons whose interior is not one connected region. REQUIRES: finite coordinates in the domain, no
/// edge of length zero. Cost: O(n log n).
std::optional<Fault> check_plane(const Edges& edges);

}  // namespace oblast::verify
