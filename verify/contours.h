// The checks of single contours: their form, whether they are simple, and which are outer contours.
#pragma once

#include <optional>

#include "verify/edges.h"

namespace oblast::verify {

/// Checks that offsets increase and end at the sizes of their arrays, and that each polygon has a contour.
std::optional<Fault> check_offsets(const RegionView& regions);

/// Checks that coordinates are finite and in the domain, that contours have at least three vertices, and that no
/// neighbours are equal.
std::optional<Fault> check_vertices(const Edges& edges);

/// With `ogc`: no contour visits a vertex twice. With `leonov_nikitin`: every walk follows one sector of the interior
/// at each vertex. REQUIRES: check_plane found no fault. Cost: O(n log n).
std::optional<Fault> check_walks(const Edges& edges, ContourConvention convention);

/// The first contour of each polygon is an outer one, the others are holes.
/// REQUIRES: check_plane found no fault. Cost: linear.
std::optional<Fault> check_roles(const Edges& edges);

}  // namespace oblast::verify
