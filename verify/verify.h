// The independent checker: slow, simple, exact rationals; it shares no code with the pipeline.
//
//   check_closed       G2: is this set of contours closed and valid?       (any tool's output)
//   check_canonical    G3: is it in canonical form?                        (oblast's output)
//   check_result       both
//   check_against      G1, G3a, G4: is it the right answer?                (verify/against.h; small inputs)
#pragma once

#include <oblast/error.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <optional>
#include <string>

namespace oblast::verify {

/// The first fault found and where it is.
struct Fault {
  std::string what;  ///< one sentence with the coordinates concerned
  Place place;       ///< polygon, contour and vertex, as far as they apply
};

/// Proves G2, exactly:
/// - offsets are consistent; coordinates are finite and in the domain; contours have at least three
///   vertices and no repeated neighbours;
/// - edges meet only at common end points;
/// - every polygon's interior lies on the left of all its contours, no two polygons overlap, and each
///   interior is one connected region (so holes lie inside their own outer contour and in no other hole);
/// - the first contour of each polygon is its outer one, counter-clockwise; the others are holes, clockwise;
/// - under `ogc` no contour visits a vertex twice; under `leonov_nikitin` contours may touch themselves
///   but each walk hugs one sector of the interior at every vertex.
/// Cost: O(n log n) time, O(n) memory; exact arithmetic only where doubles with an error bound cannot decide.
std::optional<Fault> check_closed(const RegionView& regions, ContourConvention convention = ContourConvention::ogc);

/// Checks the form of G3: no -0.0; each contour starts at its lexicographically smallest vertex (where
/// it visits that one repeatedly, with the rotation that is smallest as a sequence); polygons ordered
/// by their outer contours as sequences of vertices; so are the holes of each polygon.
/// REQUIRES: check_closed found no fault. Cost: linear, but for touching contours.
std::optional<Fault> check_canonical(const RegionView& regions);

/// check_closed, then check_canonical.
std::optional<Fault> check_result(const RegionView& result, ContourConvention convention = ContourConvention::ogc);

}  // namespace oblast::verify
