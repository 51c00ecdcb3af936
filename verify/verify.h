// The independent checker: slow, simple, exact rationals; it shares no code with the pipeline.
#pragma once

#include <optional>
#include <string>

#include <oblast/error.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

namespace oblast::verify {

/// The first fault found and where it is.
struct Fault {
  std::string what;   ///< one sentence with the coordinates concerned
  Place place;        ///< contour and vertex
};

/// Proves G2 and the form of G3 for a result, exactly: coordinates finite; contours of at least three
/// vertices, no repeated neighbours; edges meet only at common end points; under `ogc` every ring
/// simple; outer contours counter-clockwise, holes clockwise and inside their own outer contour;
/// polygons disjoint; canonical starts and order. Cost: O((n + k) log n) expected, exact tests
/// only where a floating-point interval cannot decide.
std::optional<Fault> check_result(const RegionView& result, ContourConvention convention = ContourConvention::ogc);

}  // namespace oblast::verify
