// Is a result the right answer? G1, G3a and G4 by recomputation with exact rationals. Small inputs only.
#pragma once

#include <cstdint>
#include <optional>

#include "verify/verify.h"

namespace oblast::verify {

/// Where the vertices of a result come from, and how far they are from where they should be.
struct Provenance {
  std::uint64_t input_vertices = 0;      ///< bit for bit a vertex of an operand
  std::uint64_t intersections = 0;       ///< the correctly rounded intersection of two input edges
  std::uint64_t later_rounds = 0;        ///< neither: an intersection of pieces that rounding had moved
  double largest_displacement_ulps = 0;  ///< of any vertex from the nearest input edge, see check_against
};

/// Compares `result` with A op B. The first fault, or none:
/// - G1: every vertex is an input vertex, or the correctly rounded intersection of two input edges, or
///   (a later rounding round) within the bound of two input edges;
/// - G4: both ends of every edge of the result lie within the bound of one and the same input edge (unless
///   collinear vertices were dropped, which joins edges);
/// - every place that is inside the result and not inside A op B, or the reverse, lies within the bound of an
///   input edge, and all such places together are no larger than the bound times the length of all edges;
/// - G3a, with CollinearVertices::keep: no input vertex lies in the interior of an edge of the result, but where
///   edges cancelled; no vertex is left of an edge that noding cut in vain. With CollinearVertices::drop: no vertex
///   lies exactly between its neighbours, but where contours touch.
///
/// The bound is `bound_ulps` units in the last place of the largest coordinate of the operands.
/// REQUIRES: check_result found no fault. Cost: O(n^3) rationals; made for less than about 100 edges.
std::optional<Fault> check_against(const RegionView& a, const RegionView& b, Operation operation,
                                   const Options& options, const RegionView& result, double bound_ulps = 4,
                                   Provenance* provenance = nullptr);

}  // namespace oblast::verify
