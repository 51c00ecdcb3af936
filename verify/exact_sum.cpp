// Fixed-point numbers with 1,536 bits.
#include "verify/exact_sum.h"

#include <cmath>

namespace oblast::verify {

// The product of two 53-bit numbers is the sum of two such numbers, which a fused multiply-add computes. Coordinates
// are multiples of 2^-352 up to 2^300, so the smaller part is a multiple of 2^-704.
void ExactSum::add_product(double x, double y) {
  const double product = x * y;
  add(product);
  add(std::fma(x, y, -product));
}

// 53 bits, shifted by up to 31, are divided over three limbs. Each limb grows by less than 2^33 per term, so 2^29 terms
// can be added before the limbs must be carried.
void ExactSum::add(double term) {
  if (term == 0) return;
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(term, &exponent), 53));
  const int position = exponent - 53 - lowest_exponent;
  const std::size_t limb = static_cast<std::size_t>(position / 32);
  const int shift = position % 32;
  const std::int64_t sign = mantissa < 0 ? -1 : 1;
  const auto magnitude = static_cast<std::uint64_t>(sign * mantissa);
  const std::uint64_t low = (magnitude & 0xffffffff) << shift, high = (magnitude >> 32) << shift;
  limbs_[limb] += sign * static_cast<std::int64_t>(low & 0xffffffff);
  limbs_[limb + 1] += sign * static_cast<std::int64_t>((low >> 32) + (high & 0xffffffff));
  limbs_[limb + 2] += sign * static_cast<std::int64_t>(high >> 32);
  if (++since_carry_ == std::uint32_t{1} << 29) carry();
}

void ExactSum::carry() {
  for (std::size_t i = 0; i + 1 < limb_count; ++i) {
    const std::int64_t over = limbs_[i] >> 32;  // rounds down
    limbs_[i] -= over * (std::int64_t{1} << 32);
    limbs_[i + 1] += over;
  }
  since_carry_ = 0;
}

Rational ExactSum::value() const {
  Integer sum = 0;
  for (std::size_t i = limb_count; i-- > 0;) sum = sum * (std::int64_t{1} << 32) + limbs_[i];
  return Rational(sum, Integer(1) << -lowest_exponent);
}

Rational exact_area_of(const RegionView& regions) {
  ExactSum twice;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const auto contour = regions.contour(c);
    for (std::size_t v = 0; v < contour.size(); ++v) {
      const Point &p = contour[v], &q = contour[v + 1 == contour.size() ? 0 : v + 1];
      twice.add_product(p.x, q.y);
      twice.add_product(-q.x, p.y);
    }
  }
  return twice.value() / 2;
}

double length_of_edges(const RegionView& regions) {
  double length = 0;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const auto contour = regions.contour(c);
    for (std::size_t v = 0; v < contour.size(); ++v) {
      const Point &p = contour[v], &q = contour[v + 1 == contour.size() ? 0 : v + 1];
      length += std::hypot(q.x - p.x, q.y - p.y);
    }
  }
  return length;
}

}  // namespace oblast::verify
