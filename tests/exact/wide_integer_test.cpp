// Whole numbers of thousands of bits against Boost's. Only signs can be seen, so differences are compared.
#include "exact/wide_integer.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "generators/random.h"

namespace oblast::internal::exact {
namespace {

using generators::Random;
using Integer = boost::multiprecision::cpp_int;

/// The same number in both arithmetics.
struct Both {
  WideInteger wide;
  Integer boost;
};

Both draw(Random& random) {
  if (random.one_in(10)) return {};
  const double mantissa = random.one_in(2) ? std::floor(random.unit() * 0x1p53) : random.between(1, 3);
  const int shift = random.one_in(2) ? random.between(0, 70) : random.between(0, 700);
  const double value = random.one_in(2) ? mantissa : -mantissa;
  return {WideInteger::scaled(value, shift), Integer(value) << shift};
}

TEST(WideInteger, scales) {
  EXPECT_EQ(WideInteger::scaled(0, 352).sign(), 0);
  EXPECT_EQ((WideInteger::scaled(0.375, 3) - WideInteger::scaled(3, 0)).sign(), 0);
  EXPECT_EQ((WideInteger::scaled(-0x1p-300, 352) + WideInteger::scaled(0x1p52, 0)).sign(), 0);
  EXPECT_EQ((WideInteger::scaled(0x1p300, 352) - WideInteger::scaled(0x1.fffffffffffffp299, 352)).sign(), 1);
}

TEST(WideInteger, sumsDifferencesAndProductsAreExact) {
  Random random(1);
  int signs[3] = {};
  for (int round = 0; round < 5000; ++round) {
    Both n[4];
    for (Both& b : n) b = draw(random);
    const WideInteger wide = n[0].wide * n[1].wide - n[2].wide * n[3].wide + n[0].wide;
    const Integer boost = n[0].boost * n[1].boost - n[2].boost * n[3].boost + n[0].boost;
    ASSERT_EQ(wide.sign(), boost.sign());
    ++signs[1 + wide.sign()];
    // Equal numbers by two ways: an error in any limb shows.
    const WideInteger &p = n[0].wide, &q = n[1].wide, &r = n[2].wide;
    ASSERT_EQ(((p + q) * (p - q) - (p * p - q * q)).sign(), 0);
    ASSERT_EQ(((p + q) * r - (q * r + r * p)).sign(), 0);
    ASSERT_EQ(((p - q) + (q - r) + (r - p)).sign(), 0);
    // One more is more.
    ASSERT_EQ((p * q + WideInteger::scaled(1, 0) - q * p).sign(), 1);
  }
  for (const int count : signs) EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace oblast::internal::exact
