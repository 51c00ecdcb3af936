// Checks whether a large result is right: exact membership of many points, and along many lines.
//
// Facts about a rounded result (G4): each input edge becomes a chain with the same ends. The chain stays in the box of
// the edge, is monotone in x and y, and lies within the bound of the edge. (This also holds for edges of polygons that
// are resolved first, and for edges that were straightened when a trace was removed.) So it is certain on which side of
// the edge a point p lies, unless p lies in the box of the edge and within the bound of it. Call those edges *uncertain
// at p*. Each of them may be on either side of p, independently of the others.
//
//            . .  p3 . . . . .        p1: no edge is uncertain. The result has p1 exactly if A op B has.
//   p1    . --------------- .  edge   p2: within the bound. If A op B is the same on both sides of the edge, the
//          . . . p2 . . . .           result must agree. If not, p2 is *too near to judge*.
//                                     p3: just outside the bound: certain.
//
// The same argument along a line: an edge that crosses the line also crosses it once after rounding, within the bound
// (measured along the line) of the old crossing. Between these places nothing may change in the result. All these
// stretches, on all lines, are compared with A op B.
//
// Sides are decided exactly (verify/predicates.h). Doubles with an error bound, then 100 bits, decide whether an edge
// is uncertain. In doubt it is, which only means that fewer points are judged. Coordinates along lines are doubles with
// an error bound. The oracle shares no code with src/.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <optional>
#include <string>

#include "verify/probes.h"

namespace oblast::verify {

struct OracleOptions {
  FillRule fill_a;
  FillRule fill_b;
  std::uint64_t points = 200'000;  ///< approximate number of points
  std::uint32_t lines = 1'000;     ///< number of lines, half of them vertical; 0: none
  std::uint64_t seed = 1;          ///< seed of the random points and lines
  double bound_ulps = 4;           ///< in units in the last place of the largest coordinate of A and B; more than 0
  int threads = 0;                 ///< 0: all cores. The findings do not depend on it.
};

struct OracleReport {
  struct Count {
    std::uint64_t certain = 0;       ///< judged: further than the bound from every edge
    std::uint64_t within_bound = 0;  ///< judged, although within the bound: both sides agree
    std::uint64_t too_near = 0;      ///< not judged
  };
  Count points[probe_kinds];        ///< by ProbeKind
  std::uint64_t lines = 0;          ///< lines followed
  std::uint64_t stretches = 0;      ///< stretches of them judged
  double bound = 0;                 ///< in coordinate units
  double largest_displacement = 0;  ///< of the tested vertices of the result from an input edge, in coordinate units
  double largest_displacement_ulps = 0;
};

/// A place at which the result is wrong.
struct WrongPlace {
  std::string what;  ///< one sentence
  Point at;
  bool in_a = false, in_b = false;  ///< whether the place is in A and in B, if `what` is about membership
};

/// Searches for places at which `result` is not A op B. For the union of one operand, B is empty. Returns the first
/// one, in the order in which points, then lines, were chosen; nothing if no place is wrong. REQUIRES: offsets are
/// valid; coordinates are in the domain; check_closed(result) found no fault. Cost: O(n log(points) + points) for short
/// edges; a long edge counts about sqrt(points) times. For lines: sorting their crossings with edges. Memory: O(n +
/// points).
std::optional<WrongPlace> look_for_wrong_place(const RegionView& a, const RegionView& b, Operation operation,
                                               const RegionView& result, const OracleOptions& options,
                                               OracleReport* report = nullptr);

}  // namespace oblast::verify
