// Areas whichever way contours run, the same on any number of threads, and bounds.
#include <gtest/gtest.h>
#include <oblast/measure.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <cmath>

#include "generators/hostile.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using verify::regions_of;

TEST(Measure, areaDoesNotDependOnDirections) {
  EXPECT_EQ(area(regions_of("0 0, 4 0, 4 3, 0 3")), 12);
  EXPECT_EQ(area(regions_of("0 3, 4 3, 4 0, 0 0")), 12);
  EXPECT_EQ(area(regions_of("0 0, 4 0, 4 3, 0 3; 1 1, 1 2, 2 2, 2 1")), 11);
  EXPECT_EQ(area(regions_of("0 0, 4 0, 4 3, 0 3; 1 1, 2 1, 2 2, 1 2 | 9 0, 9 1, 10 1, 10 0")), 12);
  EXPECT_EQ(area(RegionSet{}), 0);
  EXPECT_EQ(area(regions_of("1 1, 5 5")), 0);
  const RegionSet set = regions_of("0 0, 4 0, 4 3, 0 3 | 9 0, 9 1, 10 1, 10 0");
  EXPECT_EQ(area(set.polygon(1)), 1);
}

TEST(Measure, areaOfResultsIsTheirSignedArea) {
  for (const auto& generator : generators::hostile_generators()) {
    const auto [a, b] = generator.make(1, generator.larger);
    const RegionSet result = overlay(a, b, Operation::unite);
    double scale = 0;
    for (const Point& p : result.points) scale = std::max({scale, std::fabs(p.x), std::fabs(p.y)});
    const double largest = scale * scale * static_cast<double>(result.points.size());
    EXPECT_NEAR(area(result) / largest, signed_area(result) / largest, 0x1p-48) << generator.name;
    CallOptions one;
    one.threads = 1;
    EXPECT_EQ(area(result, one), area(result)) << generator.name;
  }
}

TEST(Measure, boundsHoldAllPoints) {
  EXPECT_FALSE(bounds(RegionSet{}));
  EXPECT_EQ(bounds(regions_of("3 4")), (oblast::Box{3, 4, 3, 4}));
  EXPECT_EQ(bounds(regions_of("0 -2, 4 0, 4 3, 0 3 | 9 0, 9 1, 10 1, 10 0")), (oblast::Box{0, -2, 10, 3}));
  EXPECT_FALSE(std::signbit(bounds(regions_of("-0.0 0, -1 0, -1 1"))->x1));
  const RegionSet set = regions_of("0 -2, 4 0, 4 3, 0 3 | 9 0, 9 1, 10 1, 10 0");
  EXPECT_EQ(bounds(set.polygon(1)), (oblast::Box{9, 0, 10, 1}));
}

TEST(Measure, badDataIsRefused) {
  EXPECT_THROW((void)area(RegionSet{{{NAN, 0}}, {1}, {}}), Error);
  EXPECT_THROW((void)bounds(RegionSet{{{0, INFINITY}}, {1}, {}}), Error);
  EXPECT_THROW((void)area(RegionSet{{{0, 0}}, {2}, {}}), Error);
}

}  // namespace
}  // namespace oblast::internal
