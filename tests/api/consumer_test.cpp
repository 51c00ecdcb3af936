// The public interface as a user sees it: one header, flat arrays in, a region set out.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace {

using oblast::Point;

oblast::RegionSet square(double x, double y, double side) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {4}, {1}};
}

TEST(Consumer, OverlapOfTwoSquares) {
  const oblast::RegionSet result = oblast::overlay(square(0, 0, 2), square(1, 1, 2), oblast::Operation::intersection);
  EXPECT_EQ(result, square(1, 1, 1));
}

TEST(Consumer, CallersArraysAreViewedNotOwned) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {6, 0}, {6, 4}, {2, 4}};
  const std::vector<std::uint32_t> contour_ends = {4, 8};
  const oblast::RegionSet result = oblast::unite({points, contour_ends, {}});
  EXPECT_EQ(oblast::signed_area(result), 24);
  EXPECT_EQ(result.polygon_ends.size(), 1u);
}

TEST(Consumer, StatisticsAreFilled) {
  oblast::Statistics statistics;
  oblast::Options options;
  options.statistics = &statistics;
  oblast::overlay(square(0, 0, 2), square(1, 1, 2), oblast::Operation::unite, options);
  EXPECT_EQ(statistics.input_vertices, 8u);
  EXPECT_EQ(statistics.output_vertices, 8u);
  EXPECT_EQ(statistics.intersections, 2u);
  EXPECT_GE(statistics.rounds, 1u);
}

TEST(Consumer, BadDataIsAnErrorWithAPlace) {
  oblast::RegionSet bad = square(0, 0, 2);
  bad.points[2].y = std::numeric_limits<double>::quiet_NaN();
  try {
    oblast::overlay(square(0, 0, 1), bad, oblast::Operation::unite);
    FAIL() << "a NaN was accepted";
  } catch (const oblast::Error& error) {
    EXPECT_EQ(error.code(), oblast::ErrorCode::not_finite);
    EXPECT_EQ(error.place().operand, 1u);
    EXPECT_EQ(error.place().contour, 0u);
    EXPECT_EQ(error.place().vertex, 2u);
  }
}

}  // namespace
