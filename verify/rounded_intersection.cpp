// Intersects segments by integers on a common scale.
#include "verify/rounded_intersection.h"

#include <oblast/domain.h>

#include <array>
#include <cmath>
#include <utility>

#include "verify/rational.h"
#include "verify/scaled.h"

namespace oblast::verify {
namespace {

// A point as two quotients with one positive denominator, in units of 2^exponent. Such a point needs no greatest common
// divisors, which are most of the cost of a Rational.
struct QuotientPoint {
  Integer x;
  Integer y;
  Integer denominator;
  int exponent;

  Rational rational(const Integer& numerator) const {
    return exponent < 0 ? Rational(numerator, denominator << -exponent) : Rational(numerator << exponent, denominator);
  }

  double rounded(const Integer& numerator) const {
    const double nearest = round_quotient(numerator, denominator, exponent);
    return std::abs(nearest) >= domain_smallest ? nearest : round_into_domain(rational(numerator));
  }
};

std::optional<QuotientPoint> common_point(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Scale scale(std::array{a, b, c, d});
  const ScaledPoint p = scale(a), q = scale(b), r = scale(c), s = scale(d);
  const WideInteger dx1 = q.x - p.x, dy1 = q.y - p.y, dx2 = s.x - r.x, dy2 = s.y - r.y;
  const WideInteger px = r.x - p.x, py = r.y - p.y;
  WideInteger determinant = dx1 * dy2 - dy1 * dx2;
  if (determinant.is_zero()) {
    // Parallel segments have exactly one common point only if they are collinear and touch at ends. Overlapping ones
    // have many.
    if (dx1 * py != dy1 * px) return std::nullopt;
    const auto at = [&](const Point& end) {
      const ScaledPoint scaled = scale(end);
      return QuotientPoint{Integer(scaled.x), Integer(scaled.y), 1, scale.exponent()};
    };
    const auto [low1, high1] = lexicographically_less(a, b) ? std::pair(a, b) : std::pair(b, a);
    const auto [low2, high2] = lexicographically_less(c, d) ? std::pair(c, d) : std::pair(d, c);
    if (high1 == low2) return at(high1);
    if (high2 == low1) return at(high2);
    return std::nullopt;
  }
  // The point is a + t (b - a) = c + u (d - c), with t and u from 0 to 1, both in units of 1 / determinant.
  WideInteger t = px * dy2 - py * dx2, u = px * dy1 - py * dx1;
  if (determinant.sign() < 0) {
    determinant = -determinant;
    t = -t;
    u = -u;
  }
  if (t.sign() < 0 || t > determinant || u.sign() < 0 || u > determinant) return std::nullopt;
  const Integer denominator(determinant), along(t);
  return QuotientPoint{Integer(p.x) * denominator + along * Integer(dx1),
                       Integer(p.y) * denominator + along * Integer(dy1), denominator, scale.exponent()};
}

}  // namespace

std::optional<Point> rounded_intersection(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto point = common_point(a, b, c, d);
  if (!point) return std::nullopt;
  return Point{point->rounded(point->x), point->rounded(point->y)};
}

}  // namespace oblast::verify
