// The sweep's verdict on random contours against the plainest oracle there is: every pair of edges.
#include <gtest/gtest.h>

#include <random>

#include "verify/edges.h"
#include "verify/predicates.h"
#include "verify/rational.h"
#include "verify/sweep.h"

namespace oblast::verify {
namespace {

// Meeting, by rationals alone: no code in common with predicates.cpp.
bool meet_badly_by_rationals(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (const auto meeting = intersection_of_segments(a, b, c, d)) {
    const auto is_end = [&](const Point& p, const Point& q) {
      return *meeting == RationalPoint(p) || *meeting == RationalPoint(q);
    };
    return !is_end(a, b) || !is_end(c, d);
  }
  const auto on = [](const Point& p, const Point& q, const Point& r) {
    return squared_distance(RationalPoint(p), q, r).is_zero();
  };
  return on(a, c, d) || on(b, c, d) || on(c, a, b) || on(d, a, b);
}

bool any_pair_meets_badly(const Edges& edges) {
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (std::uint32_t f = 0; f < e; ++f) {
      if (meet_badly_by_rationals(edges.from(e), edges.to(e), edges.from(f), edges.to(f))) return true;
    }
  }
  return false;
}

bool says_badly(const std::optional<Fault>& fault) {
  return fault && fault->what.find("elsewhere than at a common end point") != std::string::npos;
}

RegionSet random_contours(std::mt19937& random, int contours, int grid, double step) {
  RegionSet regions;
  std::uniform_int_distribution<int> coordinate(0, grid), corners(3, 5);
  for (int c = 0; c < contours; ++c) {
    const int n = corners(random);
    const std::size_t begin = regions.points.size();
    for (int i = 0; i < n; ++i) {
      const Point p{1 + step * coordinate(random), 1 + step * coordinate(random)};
      if (regions.points.size() == begin || (regions.points.back() != p && regions.points[begin] != p)) {
        regions.points.push_back(p);
      }
    }
    if (regions.points.size() - begin < 3) {
      regions.points.resize(begin);
      continue;
    }
    regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
    regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
  }
  return regions;
}

// REQUIRES: a good part of the cases meet, and a good part do not.
void compare(int grid, double step, int contours, unsigned seed) {
  std::mt19937 random(seed);
  int bad = 0, good = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const RegionSet regions = random_contours(random, 1 + trial % contours, grid, step);
    const Edges edges(regions);
    const bool expected = any_pair_meets_badly(edges);
    (expected ? bad : good)++;
    ASSERT_EQ(says_badly(check_plane(edges)), expected) << "trial " << trial;
  }
  EXPECT_GT(bad, 400);
  EXPECT_GT(good, 400);
}

TEST(SweepAgainstPairs, onSmallIntegers) { compare(12, 1, 3, 1); }
TEST(SweepAgainstPairs, onTinyGrids) { compare(3, 1, 2, 2); }
TEST(SweepAgainstPairs, onUnitsInTheLastPlace) { compare(6, 0x1p-52, 2, 3); }
TEST(SweepAgainstPairs, onCoordinatesThatRound) { compare(1000, 0.1, 4, 4); }

TEST(Predicates, sideOfLineIsExactWhereDoublesAreNot) {
  const double ulp = 0x1p-53;
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) {
      const Point p{0.5 + i * ulp, 0.5 + j * ulp};
      const int expected = j > i ? 1 : j < i ? -1 : 0;
      EXPECT_EQ(side_of_line({12, 12}, {24, 24}, p), expected);
      EXPECT_EQ(side_of_line({24, 24}, {12, 12}, p), -expected);
    }
  }
  // The ends of the domain.
  EXPECT_EQ(side_of_line({0, 0}, {0x1p300, 0x1p300}, {0x1p-300, 0x1p-300}), 0);
  EXPECT_EQ(side_of_line({-0x1p300, 0}, {0x1p300, 0}, {0, 0x1p-300}), 1);
  EXPECT_EQ(side_of_line({0, 0}, {0x1p300, 0x1.0000000000001p300}, {0x1p-300, 0x1p-300}), -1);
}

TEST(Predicates, anglesGoRoundOnce) {
  const Point u{1, 1};
  const Point round[] = {{0, 0.5}, {0.5, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 5}, {0, 2}, {0, 1}};
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) EXPECT_EQ(angle_less(u, round[i], round[j]), i < j) << i << " " << j;
  }
  EXPECT_FALSE(angle_less(u, {2, 2}, {3, 3}));
  EXPECT_FALSE(angle_less(u, {3, 3}, {2, 2}));
}

TEST(Rational, roundsToNearestEven) {
  EXPECT_EQ(round_to_nearest(Rational(1) / 3), 1.0 / 3);
  EXPECT_EQ(round_to_nearest(Rational(-2) / 3), -2.0 / 3);
  EXPECT_EQ(round_to_nearest(Rational(0)), 0.0);
  const Rational one(1), half_ulp = Rational(0x1p-53);
  EXPECT_EQ(round_to_nearest(one + half_ulp), 1.0);                               // a tie, to even
  EXPECT_EQ(round_to_nearest(one + 3 * half_ulp), 1.0 + 0x1p-51);                 // a tie, to even
  EXPECT_EQ(round_to_nearest(one + half_ulp + Rational(0x1p-300)), 1 + 0x1p-52);  // just above a tie
  EXPECT_EQ(round_to_nearest(Rational(0x1.fffffffffffffp0) + half_ulp), 2.0);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> value(-1e6, 1e6);
  for (int i = 0; i < 2000; ++i) {
    const double p = value(random), q = value(random);
    EXPECT_EQ(round_to_nearest(Rational(p)), p);
    EXPECT_EQ(round_to_nearest(Rational(p) / Rational(q)), p / q);
    EXPECT_EQ(round_to_nearest(Rational(p) * Rational(q)), p * q);
  }
}

TEST(Rational, roundsIntoTheDomain) {
  const Rational smallest(0x1p-300);
  EXPECT_EQ(round_into_domain(Rational(1) / 3), 1.0 / 3);
  EXPECT_EQ(round_into_domain(smallest), 0x1p-300);
  EXPECT_EQ(round_into_domain(-smallest * 2 / 3), -0x1p-300);
  EXPECT_EQ(round_into_domain(smallest / 2), 0.0);
  EXPECT_EQ(round_into_domain(smallest / 3), 0.0);
}

}  // namespace
}  // namespace oblast::verify
