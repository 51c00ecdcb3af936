// Cells that are rows without noding: the same bytes as noding makes, and none where noding is needed.
#include "zones/whole_cells.h"

#include <gtest/gtest.h>
#include <oblast/zones.h>

#include <algorithm>

#include "base/parallel.h"
#include "generators/random.h"
#include "zones/zone_rows.h"

namespace oblast::testing {
namespace {

using generators::Random;
using namespace internal;
using namespace internal::zoning;

RegionSet rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}};
}

/// The zones of points in the square from (0, 0) to (9, 9). With a vertex more on its side it is no rectangle, and all
/// cells are noded; the vertex is taken out of the result.
FeatureSet zones_in_square(const std::vector<Point>& points, std::vector<std::uint32_t> rows, bool all_noded) {
  RegionSet frame = rectangle(0, 0, 9, 9);
  const Point more{4.000000123, 0};
  if (all_noded) {
    frame.points.insert(frame.points.begin() + 1, more);
    frame.contour_ends[0] = 5;
  }
  FeatureSet zones = oblast::zones({{{}, {}, points}, {}, {}, std::move(rows)}, frame);
  auto& all = zones.regions.points;
  if (const auto found = std::find(all.begin(), all.end(), more); found != all.end()) {
    const auto place = static_cast<std::uint32_t>(found - all.begin());
    all.erase(found);
    for (std::uint32_t& end : zones.regions.contour_ends) end -= end > place;
  }
  return zones;
}

void expect_same(const std::vector<Point>& points, const std::vector<std::uint32_t>& rows = {}) {
  const FeatureSet apart = zones_in_square(points, rows, false), noded = zones_in_square(points, rows, true);
  EXPECT_EQ(apart.regions, noded.regions);
  EXPECT_EQ(apart.feature_ends, noded.feature_ends);
  EXPECT_EQ(apart.keys, noded.keys);
}

std::vector<Point> uniform(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) points.push_back({random.in(0, 9), random.in(0, 9)});
  return points;
}

TEST(WholeCells, OfUniformPoints) {
  for (const int count : {1, 2, 3, 10, 100, 3000}) expect_same(uniform(count, static_cast<std::uint64_t>(count)));
}

TEST(WholeCells, OfGridsAndCircles) {
  std::vector<Point> grid, bricks, circle;
  for (int i = 0; i < 30; ++i)
    for (int k = 0; k < 30; ++k) {
      grid.push_back({0.15 + 0.3 * i, 0.15 + 0.3 * k});
      bricks.push_back({0.125 + 0.25 * i + (k % 2) * 0.125, 0.25 * k});
    }
  for (int i = -25; i <= 25; ++i)
    for (int k = -25; k <= 25; ++k)
      if (i * i + k * k == 625 || i * i + k * k == 325) circle.push_back({4.5 + i / 8.0, 4.5 + k / 8.0});
  expect_same(grid);
  expect_same(bricks);
  expect_same(circle);
}

TEST(WholeCells, OfObjectsWithSeveralPoints) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < 1000; ++i) rows.push_back(i < 700 ? i + 5 : i % 50);
  expect_same(uniform(1000, 4), rows);
}

TEST(WholeCells, OfEqualPointsAndPointsOutside) {
  std::vector<Point> points = uniform(200, 5);
  points.insert(points.end(), points.begin() + 50, points.begin() + 90);
  points.push_back({-3, 4});
  points.push_back({4, 30});
  points.push_back({9, 9});
  expect_same(points);
}

/// The diagram of points, each an object, with some far away around them.
WholeCells whole_cells(const std::vector<Point>& points, const Box& box, double far) {
  WholeCells cells;
  within_call([&] {
    std::vector<Site> sites;
    const Point m{(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
    for (const Point d : {Point{far, 0}, {0, far}, {-far, 0}, {0, -far}})
      sites.push_back({{m.x + d.x, m.y + d.y}, none});
    for (std::uint32_t i = 0; i < points.size(); ++i) sites.push_back({points[i], i});
    GrowingDiagram growing({});
    growing.add(sites);
    Diagram diagram = growing.take();
    cells = take_whole_cells(diagram, box, static_cast<std::uint32_t>(points.size()));
  });
  return cells;
}

TEST(WholeCells, AreNoneWhereRoundingFoldsACell) {
  EXPECT_GT(whole_cells(uniform(300, 6), {0, 0, 9, 9}, 50).ends.size(), 200U);
  Random random(7);
  const double far = 0x1p50;  // an ulp is a quarter
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) points.push_back({far + random.below(80) * 0.25, far + random.below(80) * 0.25});
  EXPECT_TRUE(whole_cells(points, {far, far, far + 20, far + 20}, 100).empty());
}

TEST(WholeCells, TellWhenNodingMovedTheirOutline) {
  const WholeCells cells = whole_cells(uniform(300, 6), {0, 0, 9, 9}, 50);
  KeyedResult noded;
  noded.keys = {row_key(300)};
  noded.feature_ends = {1};
  for (const auto& [from, to] : cells.outline) noded.regions.points.push_back(from);
  noded.regions.contour_ends = {static_cast<std::uint32_t>(noded.regions.points.size())};
  noded.regions.polygon_ends = {1};
  EXPECT_FALSE(has_outline(noded, 300, cells));  // the vertices are not in the order of the outline
  EXPECT_FALSE(has_outline({}, 300, cells));
  EXPECT_TRUE(has_outline({}, 300, {}));
}

TEST(WholeCells, OnlyInRectangles) {
  EXPECT_TRUE(rectangle_of(rectangle(0, 1, 2, 3)));
  const RegionSet turned{{{0, 3}, {0, 1}, {2, 1}, {2, 3}}, {4}, {1}},
      clockwise{{{0, 1}, {0, 3}, {2, 3}, {2, 1}}, {4}, {1}};
  EXPECT_EQ(rectangle_of(turned)->x1, 2);
  EXPECT_EQ(rectangle_of(clockwise)->y1, 3);
  EXPECT_TRUE(rectangle_of(RegionSet{{{0, 0}, {2, 0}, {2, 3}, {0, 3}, {0, 0}}, {5}, {1}}));
  EXPECT_TRUE(rectangle_of(RegionSet{{{0, 0}, {0, 0}, {2, 0}, {2, 3}, {2, 3}, {0, 3}, {0, 0}}, {7}, {1}}));
  EXPECT_FALSE(rectangle_of(RegionSet{{{0, 0}, {1, 0}, {2, 0}, {2, 3}, {0, 3}, {0, 0}}, {6}, {1}}));
  EXPECT_FALSE(rectangle_of(RegionSet{{{1, 1}, {1, 1}, {1, 1}, {1, 1}}, {4}, {1}}));
  EXPECT_FALSE(rectangle_of(RegionSet{{{0, 0}, {2, 0}, {3, 3}, {0, 3}}, {4}, {1}}));
  EXPECT_FALSE(rectangle_of(RegionSet{{{0, 0}, {2, 0}, {2, 3}}, {3}, {1}}));
}

}  // namespace
}  // namespace oblast::testing
