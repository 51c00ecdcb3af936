// Checks whether a result is right: G1, G3a and G4, by recomputation with exact rationals. For small inputs only.
#pragma once

#include <cstdint>
#include <optional>

#include "verify/verify.h"

namespace oblast::verify {

/// The origin of the vertices of a result, and their largest displacement.
struct Provenance {
  std::uint64_t input_vertices = 0;      ///< equal to a vertex of an operand, bit for bit
  std::uint64_t intersections = 0;       ///< the correctly rounded intersection of two input edges
  std::uint64_t later_rounds = 0;        ///< all others: intersections of pieces that rounding had moved
  double largest_displacement_ulps = 0;  ///< of any vertex from the nearest input edge, see check_against
};

/// Compares `result` with A op B. Returns the first fault, or nothing. It checks:
/// - G1: every vertex is an input vertex, or the correctly rounded intersection of two input edges, or (from a later
///   rounding round) within the bound of two input edges.
/// - G4: both ends of every edge of the result are within the bound of one input edge (unless collinear vertices were
///   dropped, which joins edges).
/// - Every place that is inside the result but not inside A op B, or the reverse, is within the bound of an input edge.
/// The
///   total area of these places is at most the bound times the length of all edges.
/// - G3a, with CollinearVertices::keep: no input vertex lies inside an edge of the result, unless edges cancelled
/// there. No
///   vertex remains on an edge that noding cut unnecessarily. With CollinearVertices::drop: no vertex lies exactly
///   between its neighbours, unless contours touch there.
///
/// The bound is `bound_ulps` units in the last place of the largest coordinate of the operands.
/// REQUIRES: check_result found no fault. Cost: O(n^3) rationals; meant for fewer than about 100 edges.
std::optional<Fault> check_against(const RegionView& a, const RegionView& b, Operation operation,
                                   const Options& options, const RegionView& result, double bound_ulps = 4,
                                   Provenance* provenance = nullptr);

}  // namespace oblast::verify
