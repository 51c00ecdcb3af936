// The independent checker: slow and simple, with exact rationals. It shares no code with the pipeline.
//
//   check_closed       G2: whether a set of contours is closed and valid   (for output of any program)
//   check_canonical    G3: whether it is in canonical form                 (for output of oblast)
//   check_result       both
//   check_against      G1, G3a, G4: whether it is the right result         (verify/against.h; small inputs)
#pragma once

#include <oblast/error.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <optional>
#include <string>

namespace oblast::verify {

/// The first fault found and where it is.
struct Fault {
  std::string what;  ///< one sentence, with coordinates
  Place place;       ///< polygon, contour and vertex, if they apply
};

/// Proves G2, exactly:
/// - Offsets are consistent. Coordinates are finite and in the domain. Contours have at least three vertices and no
/// repeated
///   neighbours.
/// - Edges meet only at common end points.
/// - The interior of every polygon lies on the left of all its contours. No two polygons overlap. Each interior is one
///   connected region (so holes lie inside their own outer contour and in no other hole).
/// - The first contour of each polygon is its outer one, counter-clockwise. The others are holes, clockwise.
/// - With `ogc`, no contour visits a vertex twice. With `leonov_nikitin`, contours may touch themselves, but each walk
/// follows
///   one sector of the interior at every vertex.
/// Cost: O(n log n) time, O(n) memory. Exact arithmetic is used only if doubles with an error bound cannot decide.
std::optional<Fault> check_closed(const RegionView& regions, ContourConvention convention = ContourConvention::ogc);

/// Checks the canonical form (G3): there is no -0.0. Each contour starts at its lexicographically smallest vertex; if
/// it visits that vertex more than once, the rotation with the smallest sequence counts. Polygons are sorted by the
/// vertex sequences of their outer contours, and the holes of each polygon by theirs. REQUIRES: check_closed found no
/// fault. Cost: linear, except for touching contours.
std::optional<Fault> check_canonical(const RegionView& regions);

/// check_closed, then check_canonical.
std::optional<Fault> check_result(const RegionView& result, ContourConvention convention = ContourConvention::ogc);

}  // namespace oblast::verify
