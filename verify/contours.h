// The checks of single contours: their form, whether they are simple, which of them are outer ones.
#pragma once

#include <optional>

#include "verify/edges.h"

namespace oblast::verify {

/// Offsets that increase and end where their arrays do; no polygon without a contour.
std::optional<Fault> check_offsets(const RegionView& regions);

/// Coordinates finite and in the domain, contours of three vertices or more, no repeated neighbours.
std::optional<Fault> check_vertices(const Edges& edges);

/// Under `ogc`: no contour visits a vertex twice. Under `leonov_nikitin`: every walk hugs one sector of
/// the interior at each vertex. REQUIRES: check_plane found no fault. Cost: O(n log n).
std::optional<Fault> check_walks(const Edges& edges, ContourConvention convention);

/// The first contour of each polygon is an outer one, the others are holes.
/// REQUIRES: check_plane found no fault. Cost: linear.
std::optional<Fault> check_roles(const Edges& edges);

}  // namespace oblast::verify
