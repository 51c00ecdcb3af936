// Stage 1: what enters, cleaned, resolved and directed.
#include "collect/collect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "noding/simple_ring.h"
#include "overlay/pipeline.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using noding::Strands;
using noding::Winding;
using verify::regions_of;

struct Collected {
  Strands strands;
  Statistics statistics;
};

Collected collected(const RegionSet& a, const RegionSet* b = nullptr, FillRule rule = {}) {
  Options options;
  options.fill_a = options.fill_b = rule;
  Control control(options);
  Collected c;
  const RegionView b_view = b ? b->view() : RegionView{};
  c.strands = collect(a, b ? &b_view : nullptr, options, resolve_by_pipeline(control), c.statistics.resolved_polygons);
  return c;
}

/// Of a strand, as a contour with its winding change as direction.
double area_of(const Strands& strands, std::size_t s) {
  RegionSet ring;
  ring.points.assign(strands.points.begin() + strands.begin(s), strands.points.begin() + strands.ends[s] - 1);
  ring.contour_ends = {static_cast<std::uint32_t>(ring.points.size())};
  return signed_area(ring) * (strands.change[s].a + strands.change[s].b);
}

TEST(Collect, cleansContours) {
  RegionSet set = regions_of("0 0, 0 0, 4 0, 4 0, 4 4, 0 0, 0 0");
  set.points[0] = {-0.0, 0};
  const Strands strands = collected(set).strands;
  ASSERT_EQ(strands.size(), 1u);
  EXPECT_EQ(strands.points, (LargeArray<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 0}}));  // closed, nothing repeated
  for (const Point& p : strands.points) EXPECT_FALSE(std::signbit(p.x) || std::signbit(p.y));
}

TEST(Collect, dropsDegenerateContours) {
  RegionSet set = regions_of("1 1 | 2 2, 3 3 | 2 2, 3 3, 2 2, 3 3 | 5 5, 5 5, 5 5 | 0 0, 1 0, 2 0");
  set.contour_ends.push_back(set.contour_ends.back());  // an empty contour
  set.polygon_ends.push_back(6);
  set.polygon_ends.push_back(6);  // a polygon without contours
  EXPECT_EQ(collected(set).strands.size(), 0u);
  const auto directed = collected(set, nullptr, FillRule::nonzero()).strands;
  for (std::size_t s = 0; s < directed.size(); ++s) EXPECT_EQ(area_of(directed, s), 0);
}

TEST(Collect, simplePolygonsHaveWindingOneWhicheverWayTheyRun) {
  const RegionSet set = regions_of("0 0, 4 0, 4 4, 0 4 | 9 4, 9 0, 5 0, 5 4");
  const Strands strands = collected(set).strands;
  ASSERT_EQ(strands.size(), 2u);
  EXPECT_EQ(strands.change[0], (Winding{1, 0}));
  EXPECT_EQ(strands.change[1], (Winding{-1, 0}));  // turned by its change, the points stay
  EXPECT_EQ(strands.points[5], (Point{9, 4}));
  EXPECT_EQ(area_of(strands, 0), 16);
  EXPECT_EQ(area_of(strands, 1), 16);
  EXPECT_NE(strands.group[0], strands.group[1]);
  EXPECT_NE(strands.group[0], noding::any_group);
}

TEST(Collect, operandsHaveTheirOwnWindingNumbersAndGroups) {
  const RegionSet a = regions_of("0 0, 4 0, 4 4"), b = regions_of("0 0, 4 0, 4 4");
  const Strands strands = collected(a, &b).strands;
  ASSERT_EQ(strands.size(), 2u);
  EXPECT_EQ(strands.change[0], (Winding{1, 0}));
  EXPECT_EQ(strands.change[1], (Winding{0, 1}));
  EXPECT_NE(strands.group[0], strands.group[1]);
}

TEST(Collect, theRingOfAnOnlyPolygonIsKnownToBeSimpleWhereItIsConvex) {
  using noding::Simplicity;
  EXPECT_EQ(collected(regions_of("0 0, 4 0, 4 4, 0 4")).strands.simplicity, Array<Simplicity>{Simplicity::known});
  EXPECT_EQ(collected(regions_of("5 0, 9 0, 6 1, 5 4")).strands.simplicity, Array<Simplicity>{Simplicity::assumed});
  // A bow-tie; node_strands() finds out.
  EXPECT_EQ(collected(regions_of("0 9, 2 7, 2 9, 0 7")).strands.simplicity, Array<Simplicity>{Simplicity::assumed});
}

TEST(Collect, ringsOfALayerAreLookedAt) {
  const Collected c = collected(regions_of("0 0, 4 0, 4 4, 0 4 | 5 0, 9 0, 6 1, 5 4 | 0 9, 2 7, 2 9, 0 7"));
  ASSERT_EQ(c.strands.size(), 4u);  // the bow-tie is its two triangles
  EXPECT_FALSE(c.strands.has_assumed());
  EXPECT_EQ(c.statistics.resolved_polygons, 1u);
}

TEST(Collect, ringsOfAPolygonAreItsEvenOdd) {
  // A hole that runs the same way, an island in it, and a second ring beside.
  const Collected c =
      collected(regions_of("0 0, 9 0, 9 9, 0 9; 1 1, 8 1, 8 8, 1 8; 2 2, 3 2, 3 3, 2 3; 20 0, 21 0, 21 1, 20 1"));
  double area = 0;
  for (std::size_t s = 0; s < c.strands.size(); ++s) area += area_of(c.strands, s);
  EXPECT_EQ(area, 81 - 49 + 1 + 1);
  EXPECT_EQ(c.statistics.resolved_polygons, 0u);  // its rings do not meet
  for (const auto group : c.strands.group) EXPECT_EQ(group, c.strands.group[0]);
}

/// The area of a polygon's even-odd, and whether it had to be resolved for that.
struct EvenOdd {
  double area;
  bool resolved;
  friend bool operator==(const EvenOdd&, const EvenOdd&) = default;
};

EvenOdd even_odd(const std::string& polygon) {
  const Collected c = collected(regions_of(polygon));
  double area = 0;
  for (std::size_t s = 0; s < c.strands.size(); ++s) area += area_of(c.strands, s);
  return {area, c.statistics.resolved_polygons == 1};
}

TEST(Collect, ringsThatDoNotMeetAreTurnedByTheirDepth) {
  EXPECT_EQ(even_odd("0 0, 9 0, 9 9, 0 9; 1 1, 1 4, 4 4, 4 1"), (EvenOdd{81 - 9, false}));
  EXPECT_EQ(even_odd("0 0, 0 9, 9 9, 9 0; 1 1, 1 4, 4 4, 4 1"), (EvenOdd{81 - 9, false}));  // both reversed
  EXPECT_EQ(even_odd("0 0, 0 9, 9 9, 9 0; 1 1, 4 1, 4 4, 1 4"), (EvenOdd{81 - 9, false}));
  EXPECT_EQ(even_odd("1 1, 4 1, 4 4, 1 4; 0 0, 9 0, 9 9, 0 9"), (EvenOdd{81 - 9, false}));  // the hole comes first
  EXPECT_EQ(even_odd("0 0, 4 0, 4 4, 0 4; 6 1, 6 2, 7 2, 7 1"), (EvenOdd{16 + 1, false}));  // a hole beside the shell
  EXPECT_EQ(even_odd("0 0, 9 0, 9 9, 0 9; 1 1, 1 8, 8 8, 8 1; 2 2, 2 5, 5 5, 5 2"),         // a hole in the hole
            (EvenOdd{81 - 49 + 9, false}));
  EXPECT_EQ(even_odd("0 0, 9 0, 9 9, 5 9, 5 2, 4 2, 4 9, 0 9; 1 5, 3 5, 2 8; 6 5, 8 5, 7 8"),  // on both sides of a bay
            (EvenOdd{81 - 7 - 3 - 3, false}));
}

TEST(Collect, polygonsWhoseRingsMeetAreResolved) {
  EXPECT_EQ(even_odd("0 0, 4 0, 4 4, 0 4; 2 2, 6 2, 6 6, 2 6"), (EvenOdd{16 + 16 - 8, true}));  // they cross
  EXPECT_EQ(even_odd("0 0, 9 0, 9 9, 0 9; 0 0, 9 0, 9 9, 0 9"), (EvenOdd{0, false}));           // a ring twice
  EXPECT_EQ(even_odd("0 0, 9 0, 9 9, 0 9; 3 3, 0 0, 3 0, 3 3"), (EvenOdd{81 - 4.5, true}));     // a common edge
  EXPECT_EQ(even_odd("0 0, 9 0, 9 9, 0 9; 0 4, 4 3, 4 6"), (EvenOdd{81 - 6, true}));            // a vertex on an edge
  EXPECT_EQ(even_odd("0 0, 9 0, 9 9, 0 9; 0 0, 4 2, 2 4"), (EvenOdd{81 - 6, true}));            // a common vertex
  EXPECT_EQ(even_odd("0 0, 9 0, 9 9, 0 9; 1 1, 3 3, 3 1, 1 3"), (EvenOdd{81 - 2, true}));       // a bow-tie for a hole
}

TEST(Collect, underWindingRulesContoursEnterAsDirected) {
  const RegionSet set = regions_of("0 0, 2 2, 2 0, 0 2 | 9 4, 9 0, 5 0, 5 4");
  for (const FillRule rule : {FillRule::nonzero(), FillRule::positive(), FillRule::negative(), FillRule::even_odd()}) {
    const Strands strands = collected(set, nullptr, rule).strands;
    ASSERT_EQ(strands.size(), 2u);
    for (std::size_t s = 0; s < 2; ++s) {
      EXPECT_EQ(strands.change[s], (Winding{1, 0}));
      EXPECT_EQ(strands.group[s], noding::any_group);
    }
    EXPECT_EQ(strands.rules.parity_a, rule == FillRule::even_odd());
  }
}

TEST(RingShape, isJudgedExactly) {
  const auto shape_of = [](const std::string& text) { return ring_shape(regions_of(text).points); };
  EXPECT_EQ(shape_of("0 0, 4 0, 4 4, 0 4"), RingShape::counter_clockwise);
  EXPECT_EQ(shape_of("0 4, 4 4, 4 0, 0 0"), RingShape::clockwise);
  EXPECT_EQ(shape_of("0 0, 4 0, 4 4, 2 1, 0 4"), RingShape::counter_clockwise);
  EXPECT_EQ(shape_of("0 0, 4 0, 4 4, 2 0, 0 4"), RingShape::tangled);  // a vertex on an edge
  EXPECT_EQ(shape_of("0 0, 4 0, 4 4, 2 -1, 0 4"), RingShape::tangled);
  EXPECT_EQ(shape_of("0 0, 4 0, 2 0, 2 4"), RingShape::tangled);            // a fold
  EXPECT_EQ(shape_of("0 0, 4 0, 2 2, 4 4, 0 4, 2 2"), RingShape::tangled);  // a vertex twice
  EXPECT_EQ(shape_of("0 0, 1 0, 2 0"), RingShape::tangled);                 // flat
  EXPECT_EQ(shape_of("4 0, 2 3, 3 -1, 3 3, 1 -1"), RingShape::tangled);     // turns left only, twice around
}

TEST(RingShape, noContourWithRepeatedNeighboursIsConvex) {
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(convex_turn(square), 1);
  for (std::size_t twice = 0; twice < 4; ++twice)
    for (std::size_t begin = 0; begin < 5; ++begin) {
      std::vector<Point> ring = square;
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(twice), square[twice]);
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(begin), ring.end());
      EXPECT_EQ(convex_turn(ring), 0);
      std::reverse(ring.begin(), ring.end());
      EXPECT_EQ(convex_turn(ring), 0);
    }
}

TEST(RingShape, ofLargeRingsIsThatOfSmallOnes) {
  // A comb of 2 * 40 vertices, simple until one tooth reaches the back.
  std::vector<Point> comb{{0, -1}, {80, -1}};
  for (int i = 40; i >= 0; --i) {
    comb.push_back({2.0 * i, 5});
    if (i > 0) comb.push_back({2.0 * i - 1, 0});
  }
  EXPECT_EQ(ring_shape(comb), RingShape::counter_clockwise);
  std::vector<Point> reversed(comb.rbegin(), comb.rend());
  EXPECT_EQ(ring_shape(reversed), RingShape::clockwise);
  comb[21].y = -1;
  EXPECT_EQ(ring_shape(comb), RingShape::tangled);
}

}  // namespace
}  // namespace oblast::internal
