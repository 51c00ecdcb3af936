// The exact arrangement of up to three sets of contours, cut into trapezoids.
//
// Vertical lines through all vertices and all crossings cut the plane into slabs. No two edges cross inside
// a slab, so the edges that span it stand in one order from below to above, and cut it into trapezoids.
// Everything is rational; nothing is rounded. O(n^2) and slow: for small inputs only.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <functional>
#include <vector>

#include "verify/rational.h"

namespace oblast::verify {

/// A set of contours and the rule by which they have an inside.
struct Operand {
  RegionView regions;
  FillRule rule;
};

/// A piece of one face of the arrangement.
struct Trapezoid {
  RationalPoint centre;      ///< strictly inside
  Rational area;             ///< > 0
  std::vector<bool> inside;  ///< by operand
};

/// Calls `visit` for every trapezoid that lies between two edges of one slab: together they cover all that
/// is inside any operand.
void for_each_trapezoid(const std::vector<Operand>& operands, const std::function<void(const Trapezoid&)>& visit);

/// The truth table of the operations (section 1 of the papers' definitions).
bool selects(Operation operation, bool inside_a, bool inside_b);

/// The exact area of A op B, nothing rounded.
Rational exact_area(const Operand& a, const Operand& b, Operation operation);

/// The exact area enclosed by contours as they are directed.
Rational exact_signed_area(const RegionView& regions);

}  // namespace oblast::verify
