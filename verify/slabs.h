// The exact arrangement of up to three sets of contours, cut into trapezoids.
//
// Vertical lines through all vertices and all crossings divide the plane into slabs. No two edges cross inside a slab.
// So the edges that span it have one order from bottom to top, and divide it into trapezoids. Everything is exact. The
// order of two edges follows from their ends and their crossing. Estimates sort the crossings, and integers decide if
// estimates cannot. Cost: O(n^2) for n edges, more with many crossings. For small inputs only.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <functional>
#include <vector>

#include "verify/estimate.h"
#include "verify/rational.h"

namespace oblast::verify {

/// A set of contours and its fill rule.
struct Operand {
  RegionView regions;
  FillRule rule;
};

class Slabs;

/// A piece of one face of the arrangement. It is valid only during the visit.
class Trapezoid {
 public:
  std::vector<bool> inside;  ///< by operand

  /// A point strictly inside. (The area is greater than 0.)
  RationalPoint centre() const;
  Rational area() const;

  /// An estimate of the same point. Its error may be infinite.
  EstimatedPoint estimated_centre() const;
  Estimate estimated_area() const;

 private:
  friend class Slabs;
  const Slabs* slabs_ = nullptr;
  std::size_t slab_ = 0, low_ = 0, high_ = 0;
};

/// Calls `visit` for every trapezoid between two edges of one slab. Together they cover everything that is inside any
/// operand.
void for_each_trapezoid(const std::vector<Operand>& operands, const std::function<void(const Trapezoid&)>& visit);

/// The truth table of the operations.
bool selects(Operation operation, bool inside_a, bool inside_b);

/// The exact area of A op B, without rounding.
Rational exact_area(const Operand& a, const Operand& b, Operation operation);

/// The exact signed area of the contours, with their directions.
Rational exact_signed_area(const RegionView& regions);

}  // namespace oblast::verify
