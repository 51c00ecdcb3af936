// Results that are written into existing arrays.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include "generators/hostile.h"

namespace oblast {
namespace {

constexpr Operation operations[] = {Operation::intersection, Operation::unite, Operation::difference,
                                    Operation::symmetric_difference};

RegionSet square(double x, double y, double side) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {4}, {1}};
}

TEST(OverlayInto, givesTheBytesOfTheOther) {
  RegionSet result;
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      // Alternately small and larger ones, so the arrays were larger or smaller before.
      const auto [a, b] = generator.make(seed, seed % 2 == 0 ? 12 : generator.usual);
      for (const Operation operation : operations) {
        overlay(a, b, operation, {}, result);
        EXPECT_EQ(result, overlay(a, b, operation)) << generator.name;
      }
      unite(a, {}, result);
      EXPECT_EQ(result, unite(a)) << generator.name;
      unite(square(0, 0, 1), {}, result);
      EXPECT_EQ(result, square(0, 0, 1));
    }
  }
}

TEST(OverlayInto, windowsOfAllOutcomes) {
  RegionSet result = square(0, 0, 9);
  for (const double x : {0.5, 1.0, 3.0, -0.25}) {
    for (const double side : {0.5, 1.0, 4.0}) {
      for (const Operation operation : operations) {
        overlay(square(0, 0, 2), square(x, 0.25, side), operation, {}, result);
        EXPECT_EQ(result, overlay(square(0, 0, 2), square(x, 0.25, side), operation));
      }
    }
  }
}

TEST(OverlayInto, anOperandMayBeTheResult) {
  RegionSet sum = square(0, 0, 2), copy = sum;
  for (int i = 1; i < 20; ++i) {
    const RegionSet next = square(i, i % 3, 2);
    overlay(sum, next, i % 5 == 0 ? Operation::difference : Operation::unite, {}, sum);
    copy = overlay(copy, next, i % 5 == 0 ? Operation::difference : Operation::unite);
    ASSERT_EQ(sum, copy);
  }
  unite(sum.polygon(0), {}, sum);
  EXPECT_EQ(sum, unite(copy.polygon(0)));
}

TEST(OverlayInto, keepsTheArrays) {
  RegionSet result;
  result.points.reserve(100);
  result.contour_ends.reserve(100);
  result.polygon_ends.reserve(100);
  const Point* const points = result.points.data();
  overlay(square(0, 0, 2), square(1, 1, 2), Operation::unite, {}, result);
  EXPECT_EQ(result.points.data(), points);
  overlay(square(0, 0, 2), square(1, 1, 2), Operation::symmetric_difference, {}, result);
  EXPECT_EQ(result.points.data(), points);
  EXPECT_EQ(result, overlay(square(0, 0, 2), square(1, 1, 2), Operation::symmetric_difference));
}

TEST(OverlayInto, isEmptyOrAsItWasWhereItFails) {
  RegionSet result = square(0, 0, 2);
  Options options;
  options.threads = -1;
  EXPECT_THROW(overlay(square(0, 0, 2), square(1, 1, 2), Operation::unite, options, result), Error);
  EXPECT_TRUE(result == RegionSet{} || result == square(0, 0, 2));
}

}  // namespace
}  // namespace oblast
