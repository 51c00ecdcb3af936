// The overlay with a convex window: known results, random cases compared with the pipeline, and cases that must be
// declined.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "classics/cases.h"
#include "classics/shapes.h"
#include "classics/trial.h"
#include "classics/wkt.h"
#include "generators/soup.h"
#include "support/usual_tuning.h"
#include "window/fast_path.h"

namespace {

using namespace oblast;
using namespace oblast::internal;
using namespace oblast::tests;
using window::fast_overlay;

void expect_taken(const RegionSet& a, const RegionSet& b, Operation operation) {
  const std::optional<RegionSet> got = fast_overlay(a, b, operation, {});
  if (!got && !oblast::testing::usual_tuning) return;
  ASSERT_TRUE(got.has_value()) << wkt(a) << '\n' << wkt(b);
  EXPECT_EQ(*got, by_pipeline(a, b, operation)) << wkt(a) << '\n' << wkt(b);
}

void expect_declined(const RegionSet& a, const RegionSet& b, Operation operation, const Options& options = {}) {
  EXPECT_FALSE(fast_overlay(a, b, operation, options).has_value()) << wkt(a) << '\n' << wkt(b);
}

constexpr Operation three[] = {Operation::intersection, Operation::unite, Operation::difference};

/// A star of n vertices about the origin, of radius 1; its spikes are as long as edges are wide apart.
RegionSet star(int n) {
  std::vector<Point> ring;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n, r = i % 2 ? 1 - 3.5 / n : 1;
    ring.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return one_contour(ring);
}

TEST(WindowClip, ConvexPairsInGeneralPosition) {
  const RegionSet a = rectangle(0, 0, 4, 4);
  for (const RegionSet& b : {rectangle(1, 1, 3, 3), rectangle(-1, -1, 5, 5), rectangle(1, -1, 3, 5),
                             rectangle(2, 2, 6, 6), rectangle(5, 5, 6, 6), one_contour({{2, -1}, {5, 2}, {2, 5}})})
    for (const Operation operation : three) {
      expect_taken(a, b, operation);
      expect_taken(b, a, operation);
    }
}

TEST(WindowClip, WindowAcrossAStarOfManyVertices) {
  for (const int n : {7, 100, 3000})
    for (const double half : {0.1, 0.45, 0.71, 0.9, 2.0}) {
      expect_taken(star(n), rectangle(-half, -half, half, half * 1.01), Operation::intersection);
      expect_taken(rectangle(half, -half, half * 2, half), star(n), Operation::intersection);
    }
}

TEST(WindowClip, HolesAndSeveralPolygons) {
  RegionSet ring = rectangle(0, 0, 10, 10);
  generators::add_hole(ring, generators::rectangle(2, 2, 8, 8));
  generators::add_polygon(ring, generators::rectangle(4, 4, 6, 6));  // an island in the hole
  expect_taken(ring, rectangle(1, 1, 9, 9), Operation::intersection);
  expect_taken(ring, rectangle(1, 1, 5, 5), Operation::intersection);
  expect_taken(ring, rectangle(3, 3, 7, 7), Operation::intersection);
  expect_taken(ring, rectangle(0.5, 0.5, 1.5, 1.5), Operation::intersection);
}

// A polygon with a hole, in another polygon: in whatever order and direction its contours come, all of the square is
// covered (hostile case fed_back 95147).
TEST(WindowClip, AHoleMayComeBeforeItsOuterContour) {
  const std::vector<Point> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const RegionSet windows[] = {rectangle(-1, -1, 11, 11), rectangle(1, 1, 9, 9), rectangle(1, -1, 9, 11)};
  for (const bool square_first : {false, true})
    for (const bool hole_first : {false, true})
      for (const bool outer_runs_back : {false, true})
        for (const bool hole_runs_back : {false, true}) {
          std::vector<Point> outer{{3, 3}, {7, 3}, {7, 7}, {3, 7}}, hole{{4, 4}, {6, 4}, {6, 6}, {4, 6}};
          if (outer_runs_back) std::reverse(outer.begin(), outer.end());
          if (hole_runs_back) std::reverse(hole.begin(), hole.end());
          RegionSet regions;
          if (square_first) generators::add_polygon(regions, square);
          generators::add_polygon(regions, hole_first ? hole : outer);
          generators::add_hole(regions, hole_first ? outer : hole);
          if (!square_first) generators::add_polygon(regions, square);
          for (const RegionSet& window : windows)
            EXPECT_EQ(overlay(regions, window, Operation::intersection),
                      overlay(one_contour(square), window, Operation::intersection));
        }
}

TEST(WindowClip, FarFromTheWindowAnythingMayHappen) {
  // A bow-tie's crossing, an overlap of polygons: the parity at the window is what counts.
  RegionSet a = one_contour({{0, 0}, {20, 0}, {20, 20}, {30, 20}, {0, 1}});
  generators::add_polygon(a, generators::rectangle(18, -1, 19, 3));
  expect_taken(a, rectangle(2, 0.2, 3, 1), Operation::intersection);
}

TEST(WindowClip, Declines) {
  const RegionSet a = rectangle(0, 0, 4, 4);
  expect_declined(a, rectangle(4, 0, 6, 4), Operation::intersection);  // a shared side
  expect_declined(a, rectangle(4, 4, 6, 6), Operation::intersection);  // a corner on a corner
  expect_declined(a, a, Operation::intersection);
  expect_declined(a, rectangle(1, 1, 3, 3), Operation::symmetric_difference);
  RegionSet overlapping = rectangle(0, 0, 4, 4);
  generators::add_polygon(overlapping, generators::rectangle(1, 1, 2, 2));
  expect_declined(overlapping, rectangle(0.5, 0.5, 3, 3), Operation::intersection);    // one in the other
  expect_declined(overlapping, rectangle(0.5, 0.5, 1.5, 3), Operation::intersection);  // and both across
  const RegionSet bow_tie = one_contour({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  expect_declined(bow_tie, rectangle(1, 1, 3, 3.5), Operation::intersection);
  Options positive, vatti, drop;
  positive.fill_a = FillRule::positive();
  vatti.engine = Engine::vatti;
  drop.collinear = CollinearVertices::drop;
  for (const Options& options : {positive, vatti, drop})
    expect_declined(a, rectangle(1, 1, 5, 3), Operation::intersection, options);
}

// Wherever a contour begins, whichever way it runs, and whichever of its vertices is given twice.
TEST(WindowClip, RepeatedVerticesAreInNoResult) {
  const std::vector<Point> triangle{{-3, 0}, {1, 3}, {-3, -1}};
  const RegionSet apart = rectangle(2, 1, 4, 4), across = rectangle(-2, -4, -1, 4), around = rectangle(-9, -9, 9, 9);
  for (std::size_t twice = 0; twice < 3; ++twice)
    for (std::size_t begin = 0; begin < 4; ++begin)
      for (const bool runs_back : {false, true}) {
        std::vector<Point> ring = triangle;
        ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(twice), triangle[twice]);
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(begin), ring.end());
        if (runs_back) std::reverse(ring.begin(), ring.end());
        for (const RegionSet& other : {apart, across, around})
          for (const Operation operation : three) {
            EXPECT_EQ(overlay(one_contour(ring), other, operation),
                      by_pipeline(one_contour(triangle), other, operation));
            EXPECT_EQ(overlay(other, one_contour(ring), operation),
                      by_pipeline(other, one_contour(triangle), operation));
          }
      }
}

TEST(WindowClip, RandomCasesLikeThePipeline) {
  const WindowTrialCount count = run_window_trial(8000, 7);
  EXPECT_EQ(count.wrong, 0) << count.first_failure;
  EXPECT_GT(count.taken[static_cast<int>(Spread::grid)], 500);
  EXPECT_GT(count.taken[static_cast<int>(Spread::reals)], 500);
  EXPECT_GT(count.not_empty, 1000);
}

}  // namespace
