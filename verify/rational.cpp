// Exact rational points: rounding, intersection and distance.
#include "verify/rational.h"

#include <oblast/domain.h>

#include <cmath>

namespace oblast::verify {

namespace mp = boost::multiprecision;

double round_quotient(Integer numerator, Integer denominator, int exponent) {
  if (numerator.is_zero()) return 0.0;
  const bool negative = numerator.sign() < 0;
  numerator = mp::abs(numerator);

  const auto bits = [](const Integer& i) { return static_cast<int>(mp::msb(i)) + 1; };
  // Scale such that the quotient has 55 or 56 bits: 53 bits to keep, and at least two for rounding. The last bit also
  // says whether the division has a remainder.
  const int shift = 55 - (bits(numerator) - bits(denominator));
  if (shift > 0) {
    numerator <<= shift;
  } else {
    denominator <<= -shift;
  }
  Integer quotient, remainder;
  mp::divide_qr(numerator, denominator, quotient, remainder);
  auto mantissa = static_cast<std::uint64_t>(quotient);
  if (!remainder.is_zero()) mantissa |= 1;

  const int excess = bits(quotient) - 53;
  const std::uint64_t unit = std::uint64_t{1} << excess;
  const std::uint64_t tail = mantissa & (unit - 1);
  const std::uint64_t half = unit >> 1;
  std::uint64_t kept = mantissa >> excess;
  if (tail > half || (tail == half && (kept & 1) != 0)) ++kept;
  const double magnitude = std::ldexp(static_cast<double>(kept), excess - shift + exponent);
  return negative ? -magnitude : magnitude;
}

double round_to_nearest(const Rational& value) {
  return round_quotient(mp::numerator(value), mp::denominator(value), 0);
}

double round_into_domain(const Rational& value) {
  const Rational magnitude = mp::abs(value);
  if (magnitude >= Rational(domain_smallest)) return round_to_nearest(value);
  if (magnitude + magnitude <= Rational(domain_smallest)) return 0.0;
  return value.sign() < 0 ? -domain_smallest : domain_smallest;
}

std::optional<RationalPoint> intersection_of_segments(const Point& a, const Point& b, const Point& c, const Point& d) {
  const RationalPoint p(a), q(b), r(c), s(d);
  const Rational dx1 = q.x - p.x, dy1 = q.y - p.y;
  const Rational dx2 = s.x - r.x, dy2 = s.y - r.y;
  const Rational determinant = dx1 * dy2 - dy1 * dx2;
  if (determinant.is_zero()) {
    // Parallel segments have exactly one common point only if they are collinear and touch at ends. Overlapping ones
    // have many.
    if (!(dx1 * (r.y - p.y) - dy1 * (r.x - p.x)).is_zero()) return std::nullopt;
    const auto [low1, high1] = lexicographically_less(a, b) ? std::pair(a, b) : std::pair(b, a);
    const auto [low2, high2] = lexicographically_less(c, d) ? std::pair(c, d) : std::pair(d, c);
    if (high1 == low2) return RationalPoint(high1);
    if (high2 == low1) return RationalPoint(high2);
    return std::nullopt;
  }
  const Rational t = ((r.x - p.x) * dy2 - (r.y - p.y) * dx2) / determinant;
  const Rational u = ((r.x - p.x) * dy1 - (r.y - p.y) * dx1) / determinant;
  if (t < 0 || t > 1 || u < 0 || u > 1) return std::nullopt;
  return RationalPoint(p.x + t * dx1, p.y + t * dy1);
}

Rational squared_distance(const RationalPoint& p, const Point& a, const Point& b) {
  const RationalPoint from(a), to(b);
  const Rational dx = to.x - from.x, dy = to.y - from.y;
  Rational px = p.x - from.x, py = p.y - from.y;
  const Rational length = dx * dx + dy * dy;
  if (!length.is_zero()) {
    Rational t = (px * dx + py * dy) / length;
    if (t > 1) t = 1;
    if (t > 0) {
      px -= t * dx;
      py -= t * dy;
    }
  }
  return px * px + py * py;
}

}  // namespace oblast::verify
