// Sums of products of doubles without rounding, in linear time: the area of a result of any size.
#pragma once

#include <oblast/region_set.h>

#include <array>
#include <cstdint>

#include "verify/rational.h"

namespace oblast::verify {

/// A sum in fixed point, wide enough for products of coordinates in the domain.
///
///   value = sum of limbs_[i] 2^(32 i - 768), limbs may be large and of either sign until carried
class ExactSum {
 public:
  /// Adds x y, exactly. REQUIRES: x and y are in the domain, fewer than 2^40 of them in all.
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

/// As exact_signed_area (verify/slabs.h), for any number of vertices. Cost: linear.
Rational exact_area_of(const RegionView& regions);

/// The length of all edges, in doubles.
double length_of_edges(const RegionView& regions);

}  // namespace oblast::verify
