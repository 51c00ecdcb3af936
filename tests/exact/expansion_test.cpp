// Expansions against exact rationals: every operation is exact, and its components are in order.
#include "exact/expansion.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "generators/random.h"

namespace oblast::internal::exact {
namespace {

using generators::Random;
using Rational = boost::multiprecision::cpp_rational;

Rational rational(double x) { return Rational(x); }

template <int N>
Rational value(const Expansion<N>& e) {
  Rational sum = 0;
  for (int i = 0; i < e.size; ++i) sum += Rational(e.component[i]);
  return sum;
}

/// Coordinates of any magnitude in the domain. Many have few bits, so terms cancel.
double coordinate(Random& random) {
  if (random.one_in(8)) return 0;
  const double mantissa = random.one_in(2) ? 1 + random.unit() : 1 + random.below(4) * 0.25;
  const int range = random.one_in(2) ? 299 : 30;
  return std::ldexp(random.one_in(2) ? mantissa : -mantissa, random.between(-range, range));
}

/// Equals `expected`; components are not zero, grow, and do not overlap; sign and estimate agree.
template <int N>
void expect_value(const Expansion<N>& e, const Rational& expected) {
  ASSERT_EQ(value(e), expected);
  ASSERT_EQ(e.sign(), expected.sign());
  ASSERT_LE(e.size, N);
  for (int i = 0; i < e.size; ++i) ASSERT_NE(e.component[i], 0);
  for (int i = 1; i < e.size; ++i) {
    const double low = e.component[i - 1];
    double high = e.component[i];
    // All bits of the larger one are above the leading bit of the smaller one.
    const int lead = std::ilogb(low);
    high = std::ldexp(high, -lead - 1 > 1000 ? 1000 : -lead - 1);
    ASSERT_EQ(high, std::rint(high));
  }
  if (e.size > 0) {
    const Rational error = abs(Rational(e.estimate()) - expected);
    ASSERT_LE(error, Rational(std::ldexp(1.0, std::ilogb(e.estimate()) - 52)));
  }
}

TEST(Expansion, sumsAndProductsOfTwoDoublesAreExact) {
  Random random(1);
  for (int round = 0; round < 3000; ++round) {
    const double a = coordinate(random), b = coordinate(random);
    double x, y;
    two_sum(a, b, x, y);
    ASSERT_EQ(rational(x) + rational(y), rational(a) + rational(b));
    ASSERT_EQ(x, a + b);
    two_diff(a, b, x, y);
    ASSERT_EQ(rational(x) + rational(y), rational(a) - rational(b));
    two_product(a, b, x, y);
    ASSERT_EQ(rational(x) + rational(y), rational(a) * rational(b));
    ASSERT_EQ(x, a * b);
    if (std::fabs(a) >= std::fabs(b)) {
      fast_two_sum(a, b, x, y);
      ASSERT_EQ(rational(x) + rational(y), rational(a) + rational(b));
    }
    split(a, x, y);
    ASSERT_EQ(rational(x) + rational(y), rational(a));
    ASSERT_EQ(std::fma(x, x, -(x * x)), 0);  // the product of halves is exact
    ASSERT_EQ(std::fma(x, y, -(x * y)), 0);
  }
}

TEST(Expansion, operationsAreExact) {
  Random random(2);
  for (int round = 0; round < 2000; ++round) {
    double c[6];
    for (double& x : c) x = coordinate(random);
    if (random.one_in(4)) c[2] = c[0], c[3] = c[1];  // all cancels
    const auto p = difference(c[0], c[1]), q = difference(c[2], c[3]);
    const Rational p_value = Rational(c[0]) - Rational(c[1]), q_value = Rational(c[2]) - Rational(c[3]);
    expect_value(p, p_value);
    expect_value(-p, -p_value);
    expect_value(p * c[4], p_value * Rational(c[4]));
    expect_value(p * q, p_value * q_value);
    const auto cross = p * q - difference(c[4], c[5]) * q;
    const Rational cross_value = (p_value - (Rational(c[4]) - Rational(c[5]))) * q_value;
    expect_value(cross, cross_value);
    expect_value(cross * p, cross_value * p_value);
    expect_value(cross + p * c[5], cross_value + p_value * Rational(c[5]));
  }
}

TEST(Expansion, zeroHasNoComponents) {
  EXPECT_EQ(difference(3, 3).size, 0);
  EXPECT_EQ(difference(3, 3).sign(), 0);
  EXPECT_EQ(difference(3, 3).estimate(), 0);
  EXPECT_EQ((difference(3, 1) * difference(2, 2)).size, 0);
  EXPECT_EQ((difference(3, 1) - difference(5, 3)).size, 0);
}

}  // namespace
}  // namespace oblast::internal::exact
