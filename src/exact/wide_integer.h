// Whole numbers of a few thousand bits: the arithmetic of last resort, where a degree-4 product of
// coordinates leaves the range of doubles. Slow and simple; sign and magnitude, 32 bits a limb.
#pragma once

#include <cstdint>
#include <vector>

namespace oblast::internal::exact {

class WideInteger {
 public:
  WideInteger() = default;

  /// value * 2^shift. REQUIRES: that is a whole number.
  static WideInteger scaled(double value, int shift);

  /// -1, 0 or 1.
  int sign() const { return limbs_.empty() ? 0 : negative_ ? -1 : 1; }

  WideInteger operator-() const;
  friend WideInteger operator+(const WideInteger& p, const WideInteger& q);
  friend WideInteger operator-(const WideInteger& p, const WideInteger& q) { return p + (-q); }
  friend WideInteger operator*(const WideInteger& p, const WideInteger& q);

 private:
  using Limbs = std::vector<std::uint32_t>;

  static bool less(const Limbs& p, const Limbs& q);
  static Limbs sum(const Limbs& p, const Limbs& q);
  static Limbs difference(const Limbs& larger, const Limbs& smaller);
  void trim();

  Limbs limbs_;  ///< least significant first; the last is not zero
  bool negative_ = false;
};

}  // namespace oblast::internal::exact
