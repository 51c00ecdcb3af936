#include "verify/location.h"

#include <array>
#include <cmath>
#include <span>

#include "verify/predicates.h"
#include "verify/scaled.h"

namespace oblast::verify {
namespace {

int sign(const Estimate& e) { return e.certainly_positive() ? 1 : -e.value > e.error ? -1 : 0; }

// A coordinate less an integer, both in units of a scale: a fraction that is not reduced, which would cost more than
// all else here.
struct Difference {
  Integer numerator, denominator;

  Difference(const Rational& coordinate, const WideInteger& other, int exponent)
      : numerator(boost::multiprecision::numerator(coordinate)),
        denominator(boost::multiprecision::denominator(coordinate)) {
    if (exponent < 0)
      numerator <<= -exponent;
    else
      denominator <<= exponent;
    numerator -= Integer(other) * denominator;
  }
};

int side_by_integers(const Point& a, const Point& b, const RationalPoint& p) {
  const Scale scale(std::array{a, b});
  const ScaledPoint from = scale(a), to = scale(b);
  const Difference x(p.x, from.x, scale.exponent()), y(p.y, from.y, scale.exponent());
  const Integer left = Integer(to.x - from.x) * y.numerator * x.denominator;
  const Integer right = Integer(to.y - from.y) * x.numerator * y.denominator;
  return (left > right) - (left < right);
}

}  // namespace

Location::Location(const RationalPoint& p) {
  const auto estimated = [](const Rational& value) {
    const double rounded = round_to_nearest(value);
    return Estimate(rounded, std::abs(rounded) * 0x1p-52L);
  };
  estimate_ = {estimated(p.x), estimated(p.y)};
  exact_ = p;
  const Point rounded_ = rounded();
  is_double_ = p.x == Rational(rounded_.x) && p.y == Rational(rounded_.y);
  if (is_double_) estimate_ = EstimatedPoint(rounded_);
}

Location::Location(const Location& p, const Location& q) : first_(p.rounded()), second_(q.rounded()) {
  const auto middle = [](const Estimate& a, const Estimate& b) { return (a + b) * Estimate(0.5); };
  estimate_ = {middle(p.estimate_.x, q.estimate_.x), middle(p.estimate_.y, q.estimate_.y)};
  if (p.is_double() && q.is_double()) return;
  exact_ = RationalPoint((p.exact().x + q.exact().x) / 2, (p.exact().y + q.exact().y) / 2);
}

const RationalPoint& Location::exact() const {
  if (!exact_) {
    const RationalPoint p(first_), q(second_);
    exact_ = RationalPoint((p.x + q.x) / 2, (p.y + q.y) / 2);
  }
  return *exact_;
}

Box Location::box() const {
  const auto down = [](long double v) { return std::nextafter(static_cast<double>(v), -HUGE_VAL); };
  const auto up = [](long double v) { return std::nextafter(static_cast<double>(v), HUGE_VAL); };
  return {Point{down(estimate_.x.least()), down(estimate_.y.least())},
          Point{up(estimate_.x.most()), up(estimate_.y.most())}};
}

int side_of_line(const Point& a, const Point& b, const Location& p) {
  if (p.is_double()) return side_of_line(a, b, p.rounded());
  const Estimate determinant = (Estimate(b.x) - Estimate(a.x)) * (p.estimate().y - Estimate(a.y)) -
                               (Estimate(b.y) - Estimate(a.y)) * (p.estimate().x - Estimate(a.x));
  if (const int found = sign(determinant)) return found;
  return side_by_integers(a, b, p.exact());
}

int compare_y(const Location& p, double y) {
  const Estimate difference = p.estimate().y - Estimate(y);
  if (const int found = sign(difference)) return found;
  if (p.is_double()) {
    const double own = p.rounded().y;
    return (own > y) - (own < y);
  }
  const Point at{0, y};
  const Scale scale(std::span(&at, 1));
  return Difference(p.exact().y, scale(at).y, scale.exponent()).numerator.sign();
}

}  // namespace oblast::verify
