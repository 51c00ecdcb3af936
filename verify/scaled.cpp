// Converts doubles to integers on a common scale.
#include "verify/scaled.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace oblast::verify {
namespace {

constexpr int mantissa_bits = 53;

// The exponent e of value = m 2^e, with an integer m of 53 bits.
int exponent_of(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return exponent - mantissa_bits;
}

}  // namespace

Scale::Scale(std::span<const Point> points) : exponent_(0) {
  bool first = true;
  for (const Point& p : points) {
    for (const double value : {p.x, p.y}) {
      if (value == 0) continue;
      exponent_ = first ? exponent_of(value) : std::min(exponent_, exponent_of(value));
      first = false;
    }
  }
}

WideInteger Scale::scaled(double value) const {
  if (value == 0) return 0;
  const int exponent = exponent_of(value);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(value, -exponent));
  return WideInteger(mantissa) << (exponent - exponent_);
}

WideInteger determinant(const ScaledPoint& p, const ScaledPoint& q, const ScaledPoint& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

}  // namespace oblast::verify
