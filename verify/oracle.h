// Is a large result the right answer? Membership of many points and along many lines, exactly.
//
// What may be said for sure of a rounded result (G4): each input edge became a chain with the same ends that stays in
// the box of the edge, is monotone in x and y, and lies within the bound of the edge. (Edges of polygons that are
// resolved first, and edges straightened where a trace was taken out, are such chains too.) So the side on which a
// point p has the edge is certain unless p lies in the edge's box and within the bound of it. Call those edges
// *uncertain at p*; each may be on either side, whatever the others do.
//
//            . .  p3 . . . . .        p1: no edge is uncertain. The result has p1 exactly if A op B has.
//   p1    . --------------- .  edge   p2: within the bound. If A op B says the same whichever side of the edge it is
//          . . . p2 . . . .           on, so must the result. If not, p2 is *too near to judge*.
//                                     p3: just outside of the bound: certain.
//
// The same argument along a line: an edge that crosses the line crosses it once after rounding as well, within the
// bound (measured along the line) of where it did. Between these stretches nothing may change in the result, and
// all of them, on all lines, are compared with A op B.
//
// Sides are decided exactly (verify/predicates.h). Whether an edge is uncertain is decided by doubles with an error
// bound, then 100 bits, and in doubt yes, which only means that fewer points are judged. Coordinates along lines are
// doubles with an error bound. Nothing is shared with src/.
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
  std::uint64_t points = 200'000;  ///< how many, about
  std::uint32_t lines = 1'000;     ///< half of them upright; 0: none
  std::uint64_t seed = 1;          ///< other points and lines for another seed
  double bound_ulps = 4;           ///< in units in the last place of the largest coordinate of A and B; more than 0
  int threads = 0;                 ///< 0: all cores. What is found does not depend on it.
};

struct OracleReport {
  struct Count {
    std::uint64_t certain = 0;       ///< judged: further than the bound from every edge
    std::uint64_t within_bound = 0;  ///< judged although within it: either side would say the same
    std::uint64_t too_near = 0;      ///< not judged
  };
  Count points[probe_kinds];        ///< by ProbeKind
  std::uint64_t lines = 0;          ///< lines followed
  std::uint64_t stretches = 0;      ///< stretches of them judged
  double bound = 0;                 ///< in coordinate units
  double largest_displacement = 0;  ///< of the vertices of the result looked at, from an input edge, coordinate units
  double largest_displacement_ulps = 0;
};

/// A place where the result is not what the operation says.
struct WrongPlace {
  std::string what;  ///< one sentence
  Point at;
  bool in_a = false, in_b = false;  ///< of A and B as they are there, where `what` is about membership
};

/// Looks for places where `result` is not A op B. For a union of one operand B is empty. The first one by the order in
/// which points were chosen, else by that of lines; none if there is none.
/// REQUIRES: offsets in order; coordinates in the domain; check_closed(result) found no fault.
/// Cost: O(n log(points) + points) for edges that are short; long ones count about sqrt(points) times. Lines: their
/// crossings with edges, sorted. Memory O(n + points).
std::optional<WrongPlace> look_for_wrong_place(const RegionView& a, const RegionView& b, Operation operation,
                                               const RegionView& result, const OracleOptions& options,
                                               OracleReport* report = nullptr);

}  // namespace oblast::verify
