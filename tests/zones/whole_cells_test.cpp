// Cells that are rows without noding: the same bytes as noding makes, and none where noding is needed.
#include "zones/whole_cells.h"

#include <gtest/gtest.h>
#include <oblast/zones.h>

#include <algorithm>

#include "base/parallel.h"
#include "generators/company.h"
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

/// The zones of points in a frame. With the same frame twice no cell seems to be within it, and all cells are noded.
FeatureSet zones_within(RegionSet frame, const std::vector<Point>& points, const std::vector<std::uint32_t>& rows,
                        bool all_noded) {
  if (all_noded) generators::append(frame, RegionSet(frame));
  return oblast::zones({{{}, {}, points}, {}, {}, rows}, frame);
}

void expect_same(const RegionSet& frame, const std::vector<Point>& points,
                 const std::vector<std::uint32_t>& rows = {}) {
  const FeatureSet apart = zones_within(frame, points, rows, false), noded = zones_within(frame, points, rows, true);
  EXPECT_EQ(apart.regions, noded.regions);
  EXPECT_EQ(apart.feature_ends, noded.feature_ends);
  EXPECT_EQ(apart.keys, noded.keys);
}

void expect_same(const std::vector<Point>& points, const std::vector<std::uint32_t>& rows = {}) {
  expect_same(rectangle(0, 0, 9, 9), points, rows);
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

TEST(WholeCells, InAnyFrame) {
  const RegionSet slanted{{{4, -1}, {10, 5}, {5, 10}, {-1, 4}}, {4}, {1}};
  const RegionSet with_a_hole{
      {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 5}, {6, 6}, {5, 3}, {3, 3}}, {5, 10}, {2}};
  const RegionSet overlapping{{{0, 0}, {6, 0}, {6, 9}, {0, 9}, {3, 1}, {9, 1}, {9, 8}, {3, 8}}, {4, 8}, {1, 2}};
  const RegionSet outside = rectangle(20, 20, 30, 30);
  for (const RegionSet& frame : {slanted, with_a_hole, overlapping, outside}) {
    expect_same(frame, uniform(2000, 8));
    expect_same(frame, uniform(3, 9));
  }
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
    const FrameInterior frame(rectangle(box.x0, box.y0, box.x1, box.y1));
    cells = take_whole_cells(diagram, frame, static_cast<std::uint32_t>(points.size()));
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

}  // namespace
}  // namespace oblast::testing
