// The exact arrangement of up to three sets of contours, cut into trapezoids.
//
// Vertical lines through all vertices and all crossings cut the plane into slabs. No two edges cross inside
// a slab, so the edges that span it stand in one order from below to above, and cut it into trapezoids.
// Everything is exact. In which order two edges stand is known from their ends, and from where they cross; crossings
// are put in order by estimates, and by integers where these cannot tell. O(n^2) for n edges, more with many crossings:
// for small inputs only.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <functional>
#include <vector>

#include "verify/estimate.h"
#include "verify/rational.h"

namespace oblast::verify {

/// A set of contours and the rule by which they have an inside.
struct Operand {
  RegionView regions;
  FillRule rule;
};

class Slabs;

/// A piece of one face of the arrangement. Valid during the visit.
class Trapezoid {
 public:
  std::vector<bool> inside;  ///< by operand

  /// A point strictly inside, and the area, which is greater than 0.
  RationalPoint centre() const;
  Rational area() const;

  /// The same to within an error that may be infinite.
  EstimatedPoint estimated_centre() const;
  Estimate estimated_area() const;

 private:
  friend class Slabs;
  const Slabs* slabs_ = nullptr;
  std::size_t slab_ = 0, low_ = 0, high_ = 0;
};

/// Calls `visit` for every trapezoid that lies between two edges of one slab: together they cover all that
/// is inside any operand.
void for_each_trapezoid(const std::vector<Operand>& operands, const std::function<void(const Trapezoid&)>& visit);

/// The truth table of the operations.
bool selects(Operation operation, bool inside_a, bool inside_b);

/// The exact area of A op B, nothing rounded.
Rational exact_area(const Operand& a, const Operand& b, Operation operation);

/// The exact area enclosed by contours as they are directed.
Rational exact_signed_area(const RegionView& regions);

}  // namespace oblast::verify
