// Exact sums of products of doubles, in linear time, for the area of a result of any size.
#pragma once

#include <oblast/region_set.h>

#include <array>
#include <cstdint>

#include "verify/rational.h"

namespace oblast::verify {

/// A sum in fixed point, wide enough for products of coordinates in the domain.
///
///   value = sum of limbs_[i] 2^(32 i - 768); before they are carried, limbs may be large and have either sign
class ExactSum {
 public:
  /// Adds the exact product x y. REQUIRES: x and y are in the domain; fewer than 2^40 products in total.
  void add_product(double x, double y);
  Rational value() const;

 private:
  static constexpr int limb_count = 48;  // up to 2^768
  static constexpr int lowest_exponent = -768;

  void add(double term);
  void carry();

  std::array<std::int64_t, limb_count> limbs_{};
  std::uint32_t since_carry_ = 0;
};

/// The same as exact_signed_area (verify/slabs.h), for any number of vertices. Cost: linear.
Rational exact_area_of(const RegionView& regions);

/// The total length of all edges, computed in doubles.
double length_of_edges(const RegionView& regions);

}  // namespace oblast::verify
