// Points are located exactly: against a count of crossings over all edges, where it is hard to tell and where it is
// not.
#include <gtest/gtest.h>
#include <oblast/domain.h>
#include <oblast/locator.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/tuning.h"
#include "exact/orientation.h"
#include "generators/hostile.h"
#include "generators/random.h"
#include "locate/slab_tree.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using verify::regions_of;

Location by_all_edges(const RegionView& regions, const Point& p) {
  bool inside = false;
  for (const std::span<const Point> contour : regions.contours()) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point &a = contour[i], &b = contour[i + 1 == contour.size() ? 0 : i + 1];
      const int side = exact::orientation(a, b, p);
      if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
          p.y <= std::max(a.y, b.y))
        return Location::boundary;
      if ((a.y <= p.y) != (b.y <= p.y)) inside ^= (side > 0) == (a.y < b.y);
    }
  }
  return inside ? Location::inside : Location::outside;
}

/// Points all over, at vertices, at middles of edges, and next to either.
std::vector<Point> queries_for(const RegionView& regions, generators::Random& random, std::size_t most) {
  std::vector<Point> points;
  const auto add = [&](const Point& p) {
    if (in_domain(p.x) && in_domain(p.y)) points.push_back(p);
  };
  const auto add_with_neighbours = [&](const Point& p) {
    add(p);
    for (const double x : {std::nextafter(p.x, -INFINITY), p.x, std::nextafter(p.x, INFINITY)})
      for (const double y : {std::nextafter(p.y, -INFINITY), p.y, std::nextafter(p.y, INFINITY)})
        if (Point{x, y} != p) add({x, y});
  };
  for (std::size_t i = 0; i < most && !regions.points.empty(); ++i) {
    const auto pick = [&] { return static_cast<std::size_t>(random.below(static_cast<int>(regions.points.size()))); };
    const std::size_t v = pick();
    const Point a = regions.points[v], b = regions.points[v + 1 < regions.points.size() ? v + 1 : 0];
    add_with_neighbours(a);
    add_with_neighbours({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
    const double x = regions.points[pick()].x, y = regions.points[pick()].y;
    add({x, y});
    add({x, a.y / 2 + b.y / 2});
    const double t = random.unit();
    add({a.x + (x - a.x) * t, a.y + (y - a.y) * random.unit()});
  }
  return points;
}

void expect_exact(const RegionView& regions, const std::vector<Point>& points, const char* name) {
  const Locator locator(regions);
  std::vector<Location> locations(points.size());
  locator.locate(points, locations);
  locate::Edges edges;
  for (std::span<const Point> contour : regions.contours()) {
    for (const Point& p : contour) {
      edges.edges.push_back(static_cast<std::uint32_t>(edges.points.size()));
      edges.points.push_back(p);
    }
    if (!contour.empty()) edges.points.push_back(contour[0]);
  }
  std::erase_if(edges.edges, [&](std::uint32_t e) { return edges.from(e) == edges.to(e); });
  const locate::SlabTree slabs(edges);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Location expected = by_all_edges(regions, points[i]);
    ASSERT_EQ(locations[i], expected) << name << " at " << points[i].x << ' ' << points[i].y;
    ASSERT_EQ(locator.locate(points[i]), expected) << name;
    ASSERT_EQ(slabs.locate(points[i]), expected) << name << " by slabs at " << points[i].x << ' ' << points[i].y;
  }
}

TEST(Locator, ofASquareWithAHole) {
  const Locator locator(regions_of("0 0, 9 0, 9 9, 0 9; 3 3, 3 6, 6 6, 6 3"));
  EXPECT_EQ(locator.locate({1, 1}), Location::inside);
  EXPECT_EQ(locator.locate({4, 4}), Location::outside);
  EXPECT_EQ(locator.locate({10, 4}), Location::outside);
  EXPECT_EQ(locator.locate({9, 4}), Location::boundary);
  EXPECT_EQ(locator.locate({3, 3}), Location::boundary);
  EXPECT_EQ(locator.locate({-0.0, 0.0}), Location::boundary);
}

TEST(Locator, ofNothing) {
  for (const RegionSet& regions : {RegionSet{}, regions_of("1 1"), regions_of("1 1, 1 1, 1 1")})
    EXPECT_EQ(Locator(regions).locate({1, 1}), Location::outside);
  EXPECT_EQ(Locator(regions_of("1 1, 3 3")).locate({2, 2}), Location::boundary);
  EXPECT_EQ(Locator(regions_of("1 1, 3 1, 5 1")).locate({2, 1}), Location::boundary);
  EXPECT_EQ(Locator(regions_of("1 1, 1 3")).locate({1, 4}), Location::outside);
}

TEST(Locator, hostileResultsExactly) {
  generators::Random random(7);
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const auto [a, b] = generator.make(seed, seed < 6 ? generator.usual : generator.larger);
      const RegionSet result = overlay(a, b, seed % 2 == 0 ? Operation::unite : Operation::symmetric_difference);
      expect_exact(result, queries_for(result, random, 150), generator.name);
    }
  }
}

TEST(Locator, contoursThatCrossExactlyToo) {
  generators::Random random(8);
  for (const auto& generator : generators::hostile_generators()) {
    const auto [a, b] = generator.make(3, generator.usual);
    expect_exact(a, queries_for(a, random, 100), generator.name);
    expect_exact(b, queries_for(b, random, 100), generator.name);
  }
}

TEST(Locator, everyPlaceOfALatticeExactly) {
  // Vertices, edges and points all on the lines of cells.
  const auto [a, b] = generators::integer_grid(5, 60);
  const RegionSet result = overlay(a, b, Operation::symmetric_difference);
  std::vector<Point> points;
  for (int x = -4; x <= 80; ++x)
    for (int y = -4; y <= 80; ++y) points.push_back({x / 2.0, y / 2.0});
  expect_exact(result, points, "lattice");
}

TEST(Locator, longSliversDoNotCostTheirSquare) {
  RegionSet slivers;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double x = i;
    for (const Point& p : {Point{x, 0}, Point{x + 0.5, 0}, Point{x + 20000.5, 20000}, Point{x + 20000, 20000}})
      slivers.points.push_back(p);
    slivers.contour_ends.push_back(static_cast<std::uint32_t>(slivers.points.size()));
  }
  const Locator locator(slivers);
  for (int i = 0; i < count; ++i) {
    const double y = 1 + i % 19998, x = i + y;
    ASSERT_EQ(locator.locate({x + 0.25, y}), Location::inside);
    ASSERT_EQ(locator.locate({x + 0.75, y}), Location::outside);
    ASSERT_EQ(locator.locate({x + 0.5, y}), Location::boundary);
  }
}

/// Triangles that all have one vertex in common.
RegionSet fan(std::size_t triangles) {
  RegionSet regions;
  const auto wide = static_cast<double>(triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    const double x = 3 * static_cast<double>(i) - wide;
    for (const Point& p : {Point{0.5, 0.25}, Point{x, 100}, Point{x + 1, 100}}) regions.points.push_back(p);
    regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
  }
  return regions;
}

TEST(Locator, manyEdgesAtAVertexExactly) {
  // So many in one cell that it is looked through, divided, or left to the slabs.
  generators::Random random(9);
  for (const std::size_t edges :
       {tuning::undivided_edges, tuning::looked_at_in_a_cell, 4 * tuning::looked_at_in_a_cell})
    for (const std::size_t more : {0, 1, 2, 3}) {
      const RegionSet regions = fan((edges + more) / 2);
      expect_exact(regions, queries_for(regions, random, 40), "fan");
    }
}

TEST(Locator, cellsDividedAgainAndAgainExactly) {
  // Each half as far from the origin as the one before: at last more than all divisions can part.
  RegionSet regions;
  for (int i = 0; i < 20 * tuning::located_divisions; ++i) {
    const double r = std::ldexp(1.0, -i);
    for (const Point& p : {Point{r, r}, Point{1.5 * r, r * 1.25}, Point{1.25 * r, 1.5 * r}, Point{r, 1.75 * r}})
      regions.points.push_back(p);
    regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
  }
  generators::Random random(10);
  expect_exact(regions, queries_for(regions, random, 300), "ever smaller");
  // The same in one cell of many: a far square makes it so.
  for (const Point& p : {Point{-4000, -4000}, Point{-3999, -4000}, Point{-3999, -3999}, Point{-4000, -3999}})
    regions.points.push_back(p);
  regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
  expect_exact(regions, queries_for(regions, random, 300), "ever smaller, and far");
}

TEST(Locator, cellsOfSeveralTasksExactly) {
  // A ring, so that most cells that have edges have many.
  const std::size_t count =
      std::max<std::size_t>(3 * tuning::finished_cells_a_task / tuning::located_cells_an_edge, 60);
  RegionSet regions;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(count);
    regions.points.push_back({std::cos(angle), std::sin(angle)});
  }
  std::erase_if(regions.points, [](const Point& p) { return !in_domain(p.x) || !in_domain(p.y); });
  regions.contour_ends = {static_cast<std::uint32_t>(regions.points.size())};
  generators::Random random(11);
  expect_exact(regions, queries_for(regions, random, 60), "ring");
}

TEST(Locator, anyNumberOfPointsAtATime) {
  const auto [a, b] = generators::integer_grid(5, 60);
  const RegionSet regions = overlay(a, b, Operation::symmetric_difference);
  const Locator locator(regions);
  for (const std::size_t size : {std::size_t{1}, tuning::queries_a_block, tuning::queries_a_task, tuning::small_call})
    for (const std::size_t count : {size - 1, size, size + 1, 3 * size + 1}) {
      std::vector<Point> points;
      for (std::size_t i = 0; i < count; ++i)
        points.push_back({static_cast<double>(i * 7 % 90) / 2 - 2, static_cast<double>(i * 13 % 89) / 2 - 2});
      std::vector<Location> locations(count);
      locator.locate(points, locations);
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_EQ(locations[i], locator.locate(points[i])) << i << " of " << count;
    }
}

TEST(Locator, refusesWhatIsNoPoint) {
  const Locator locator(regions_of("0 0, 9 0, 9 9"));
  EXPECT_THROW((void)locator.locate({NAN, 0}), Error);
  const std::vector<Point> points = {{1, 1}, {0, 1e91}};
  std::vector<Location> locations(2);
  try {
    locator.locate(points, locations);
    FAIL() << "1e91 was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::out_of_domain);
    EXPECT_EQ(error.place().vertex, 1u);
  }
  EXPECT_THROW(locator.locate(points, std::span(locations).first(1)), Error);
  EXPECT_THROW(Locator(RegionSet{{{0, 0}}, {2}, {}}), Error);
  CallOptions options;
  options.most_bytes = 10;
  EXPECT_THROW(Locator(regions_of("0 0, 9 0, 9 9"), options), Error);
}

}  // namespace
}  // namespace oblast::internal
