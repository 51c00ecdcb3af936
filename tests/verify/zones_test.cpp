// The judge of zones finds planted faults, and lets right zones pass.
#include "verify/zones.h"

#include <gtest/gtest.h>

#include <random>

#include "verify/distance.h"
#include "verify/text_regions.h"
#include "verify/voronoi.h"

namespace oblast::verify {
namespace {

constexpr double ulp = 0x1p-49;  // of coordinates from 8 to 16

/// Zones in a frame, as texts of regions; an empty text is an empty row.
struct Example {
  RegionSet regions;
  std::vector<Point> line_points;
  std::vector<std::uint32_t> line_ends;
  std::vector<Point> points;
  std::string frame;
  std::vector<std::string> rows;

  std::string fault(double epsilon = 0, double moved = 0) const {
    const ZoneObjects objects(ShapeFeatures{{regions, {line_points, line_ends}, points}, {}, {}, {}});
    const RegionSet frame_set = regions_of(frame);
    FeatureSet set;
    for (std::uint32_t r = 0; r < rows.size(); ++r) {
      const RegionSet row = rows[r].empty() ? RegionSet{} : regions_of(rows[r]);
      for (const PolygonView polygon : row.polygons()) {
        for (const std::span<const Point> contour : polygon.contours()) {
          set.regions.points.insert(set.regions.points.end(), contour.begin(), contour.end());
          set.regions.contour_ends.push_back(static_cast<std::uint32_t>(set.regions.points.size()));
        }
        set.regions.polygon_ends.push_back(static_cast<std::uint32_t>(set.regions.contour_ends.size()));
      }
      set.feature_ends.push_back(static_cast<std::uint32_t>(set.regions.polygon_ends.size()));
      set.keys.push_back({r, no_feature});
    }
    const JudgedZones zones{objects, frame_set, set, set.keys};
    if (const auto found = check_zone_cover(zones, {moved, true})) return found->what;
    ZoneDistanceBounds bounds;
    bounds.epsilon = epsilon;
    const auto found = check_zone_distances(zones, bounds);
    return found ? found->what : "";
  }
};

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Two points; the border is x = 5.
Example two_points() {
  return {
      {}, {}, {}, {{0, 0}, {10, 0}}, "-5 -5, 15 -5, 15 5, -5 5", {"-5 -5, 5 -5, 5 5, -5 5", "5 -5, 15 -5, 15 5, 5 5"}};
}

/// Two squares that share a side, one of them with a notch in it, and a frame whose zones go on from there.
Example two_squares() {
  Example e;
  e.regions = regions_of("0 0, 4 0, 4 4, 0 4 | 4 0, 8 0, 8 4, 4 4");
  e.frame = "-2 -2, 10 -2, 10 6, -2 6";
  e.rows = {"-2 -2, 4 -2, 4 0, 4 4, 4 6, -2 6", "4 -2, 10 -2, 10 6, 4 6, 4 4, 4 0"};
  return e;
}

/// Two parallel lines; the border is y = 2.
Example two_lines() {
  return {{}, {{0, 0}, {8, 0}, {0, 4}, {8, 4}}, {2, 4},
          {}, "0 -2, 8 -2, 8 6, 0 6",           {"0 -2, 8 -2, 8 2, 0 2", "0 2, 8 2, 8 6, 0 6"}};
}

TEST(ZonesJudge, LetsRightZonesPass) {
  EXPECT_EQ(two_points().fault(), "");
  EXPECT_EQ(two_squares().fault(), "");
  EXPECT_EQ(two_lines().fault(), "");
}

TEST(ZonesJudge, FindsABorderThatIsMovedByTwoEpsilon) {
  Example e = two_points();
  // A place on x = 5 + t has distances 5 + t and 5 - t, so t is half of epsilon.
  e.rows = {"-5 -5, 5.25 -5, 5.25 5, -5 5", "5.25 -5, 15 -5, 15 5, 5.25 5"};
  EXPECT_EQ(e.fault(0.5), "");
  EXPECT_TRUE(holds(e.fault(0.25), "is further than another one"));
  e = two_lines();
  e.rows = {"0 -2, 8 -2, 8 1.5, 0 1.5", "0 1.5, 8 1.5, 8 6, 0 6"};
  EXPECT_EQ(e.fault(1), "");
  EXPECT_TRUE(holds(e.fault(0.5), "is further than another one"));
}

TEST(ZonesJudge, ComparesDistancesExactly) {
  Example e = two_lines();
  e.rows = {"0 -2, 8 -2, 8 1.5, 0 1.5", "0 1.5, 8 1.5, 8 6, 0 6"};
  EXPECT_TRUE(holds(e.fault(std::nextafter(1, 0)), "is further than another one"));
  EXPECT_TRUE(root_is_within(2, 1, Rational(0.41421356237309515)));  // the next doubles of sqrt(2) - 1
  EXPECT_FALSE(root_is_within(2, 1, Rational(0.41421356237309503)));
  EXPECT_TRUE(root_is_within(1, 2, 0));
  EXPECT_TRUE(root_is_within(4, 0, 2));
}

TEST(ZonesJudge, FindsSwappedRows) {
  for (Example e : {two_points(), two_squares(), two_lines()}) {
    std::swap(e.rows[0], e.rows[1]);
    EXPECT_NE(e.fault(100), "");
  }
}

TEST(ZonesJudge, FindsAGap) {
  Example e = two_points();
  e.rows[0] = "-5 -5, 4 -5, 4 5, -5 5";
  EXPECT_TRUE(holds(e.fault(100), "in no row"));
  e = two_points();
  e.rows[1] = "5 -5, 15 -5, 15 5, 5 5; 11 0, 12 1, 12 0";
  EXPECT_TRUE(holds(e.fault(100), "in no row"));
  e = two_points();  // narrower than any tolerance
  e.rows[1] = "5 -5, 15 -5, 15 5, 5 5, 5.000000000000001 0";
  EXPECT_TRUE(holds(e.fault(100), "in no row"));
  e = two_points();
  e.rows[1] = "";
  EXPECT_NE(e.fault(100), "");
}

TEST(ZonesJudge, FindsAnOverlap) {
  Example e = two_points();
  e.rows[0] = "-5 -5, 6 -5, 6 5, -5 5";
  EXPECT_NE(e.fault(100), "");
  e = two_points();
  e.rows[0] = "-5 -5, 5 -5, 5 5, -5 5 | 11 0, 12 0, 12 1";  // edges do not cross
  EXPECT_TRUE(holds(e.fault(100), "rows overlap"));
}

TEST(ZonesJudge, FindsRowsOutOfTheFrame) {
  Example e = two_points();
  e.frame = "-5 -5, 15 -5, 15 4, -5 4";
  EXPECT_TRUE(holds(e.fault(100), "out of the frame"));
}

TEST(ZonesJudge, FindsAnObjectThatIsCut) {
  Example e = two_squares();
  e.rows = {"-2 -2, 4 -2, 4 0, 3.5 2, 4 4, 4 6, -2 6", "3.5 2, 4 0, 4 -2, 10 -2, 10 6, 4 6, 4 4"};
  EXPECT_TRUE(holds(e.fault(100), "a place in regions of objects (0) is in row 1"));
  EXPECT_TRUE(holds(e.fault(100, ulp), "a place in regions of objects (0) is in row 1"));
  e.rows = {"-2 -2, 4 -2, 4 0, 3.9999999999999996 2, 4 4, 4 6, -2 6",
            "3.9999999999999996 2, 4 0, 4 -2, 10 -2, 10 6, 4 6, 4 4"};
  EXPECT_TRUE(holds(e.fault(), "a place in regions of objects (0) is in row 1"));
  EXPECT_EQ(e.fault(100, ulp), "");  // borders may cut a wall that two share
  e.regions = regions_of("0 0, 4 0, 4 4, 0 4 | 5 0, 8 0, 8 4, 5 4");
  EXPECT_TRUE(holds(e.fault(100, ulp), "a place in regions of objects (0) is in row 1"));
  e = two_lines();
  e.rows = {"0 -2, 8 -2, 8 2, 4 -1e-15, 0 2", "0 2, 4 -1e-15, 8 2, 8 6, 0 6"};
  EXPECT_TRUE(holds(e.fault(100), "a line of object 0 is not in its row"));
  e = two_points();
  e.rows = {"-5 -5, 10.5 -5, 10.5 5, -5 5", "10.5 -5, 15 -5, 15 5, 10.5 5"};
  EXPECT_TRUE(holds(e.fault(100), "a point of object 1 is in row 0"));
}

TEST(ZonesJudge, GivesOverlapsToTheLowestObject) {
  Example e;
  e.regions = regions_of("0 0, 4 0, 4 4, 0 4 | 2 0, 8 0, 8 4, 2 4");
  e.frame = "0 0, 8 0, 8 4, 0 4";
  e.rows = {"0 0, 2 0, 4 0, 4 4, 2 4, 0 4", "4 0, 8 0, 8 4, 4 4"};
  EXPECT_EQ(e.fault(), "");
  e.rows = {"0 0, 2 0, 2 4, 0 4", "2 0, 4 0, 8 0, 8 4, 4 4, 2 4"};
  EXPECT_TRUE(holds(e.fault(), "a place in regions of objects (0, 1) is in row 1"));
}

TEST(ZonesJudge, ExcusesSliversBesideEdgesThatMoved) {
  // The border meets the frame at (5, -35/6) and (5, 35/6), which are no doubles.
  Example e = two_points();
  e.frame = "-5 0, 7 -7, 15 0, 7 7";
  e.rows = {"-5 0, 5 -5.833333333333333, 5 5.833333333333333",
            "5 -5.833333333333333, 7 -7, 15 0, 7 7, 5 5.833333333333333"};
  EXPECT_EQ(e.fault(0, ulp), "");
  EXPECT_NE(e.fault(0, 0), "");
  e.rows = {"-5 0, 5 -5.8333, 5 5.833333333333333", "5 -5.8333, 7 -7, 15 0, 7 7, 5 5.833333333333333"};
  EXPECT_NE(e.fault(0, ulp), "");
  // A line crosses the squares at such places; that excuses neither a line without a row nor squares in the wrong row.
  e = two_squares();
  e.line_points = {{-1, -1}, {9, 5.5}};
  e.line_ends = {2};
  EXPECT_TRUE(holds(e.fault(0, ulp), "a line of object 2 is not in its row"));
  std::swap(e.rows[0], e.rows[1]);
  EXPECT_TRUE(holds(e.fault(0, ulp), "a place in regions of objects"));
}

TEST(ZonesJudge, KnowsTheBoundaryOfPolygons) {
  // A spike is no boundary; where two rings overlap, neither is.
  EXPECT_EQ(boundary_of(regions_of("0 0, 4 0, 6 0, 4 0, 4 4, 0 4")).size(), 4u);
  EXPECT_EQ(boundary_of(regions_of("0 0, 4 0, 4 4, 0 4; 4 1, 8 1, 8 3, 4 3")).size(), 8u);
  EXPECT_TRUE(boundary_of(regions_of("0 0, 4 4, 2 2")).empty());
}

TEST(ZonesJudge, LocatesPlacesBesideEdges) {
  const Area square({{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 4}}, {{0, 4}, {0, 0}}});
  const auto beside = [&](Point p, Point q, bool horizontal) {
    const Area::Sides sides = square.beside(Location(Location(p), Location(q)), horizontal);
    return std::pair(sides.first, sides.second);
  };
  EXPECT_EQ(beside({0, 0}, {4, 0}, true), std::pair(false, true));
  EXPECT_EQ(beside({0, 4}, {4, 4}, true), std::pair(true, false));
  EXPECT_EQ(beside({0, 0}, {0, 4}, false), std::pair(false, true));
  EXPECT_EQ(beside({4, 0}, {4, 4}, false), std::pair(true, false));
  EXPECT_EQ(beside({1, 1}, {3, 2}, false), std::pair(true, true));
  EXPECT_EQ(beside({1, 4}, {9, 4}, true), std::pair(false, false));
  EXPECT_EQ(square.where({4, 2}), Area::Where::on);
  EXPECT_EQ(square.where({0, 4}), Area::Where::on);
  EXPECT_EQ(square.where({2, 2}), Area::Where::inside);
  EXPECT_EQ(square.where({5, 4}), Area::Where::outside);
}

TEST(ZonesJudge, JudgesALargestDistance) {
  const std::vector<Point> points{{0, 0}};
  const ZoneObjects objects(ShapeFeatures{{{}, {}, points}, {}, {}, {}});
  const RegionSet frame = regions_of("-8 -8, 8 -8, 8 8, -8 8"), zone = regions_of("-3 0, 0 -3, 3 0, 0 3");
  const std::vector<FeatureKey> keys{{0, no_feature}};
  const JudgedZones zones{objects, frame, {zone, {}}, keys};
  EXPECT_FALSE(check_zone_cover(zones, {0, false}));
  EXPECT_TRUE(check_zone_cover(zones, {0, true}));
  ZoneDistanceBounds bounds;
  bounds.lower = 2.12, bounds.upper = 3;
  EXPECT_FALSE(check_zone_distances(zones, bounds));
  bounds.upper = 2.99;
  EXPECT_TRUE(check_zone_distances(zones, bounds));
  bounds.lower = 2.5, bounds.upper = 3;
  EXPECT_TRUE(check_zone_distances(zones, bounds));
}

TEST(ZonesJudge, DrawsVoronoiCells) {
  const Point square[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {2, 2}};
  const Box box({-1, -1}, {3, 3});
  const auto cells = voronoi_cells(square, box);
  ASSERT_EQ(cells.size(), 5u);
  EXPECT_EQ(cells[0].size(), 4u);
  EXPECT_TRUE(cells[4].empty());
  const RegionSet rows =
      regions_of("-1 -1, 1 -1, 1 1, -1 1 | 1 -1, 3 -1, 3 1, 1 1 | 1 1, 3 1, 3 3, 1 3 | -1 1, 1 1, 1 3, -1 3");
  EXPECT_FALSE(check_voronoi(std::span(square).first(4), box, {rows, {}}, 0));
  RegionSet moved = rows;
  for (Point& p : moved.points)
    if (p == Point{1, 1}) p.x = std::nextafter(1, 2);
  EXPECT_TRUE(check_voronoi(std::span(square).first(4), box, {moved, {}}, 0.1));
}

// Exact cells with rounded vertices are zones: the parts of the judge agree with each other.
TEST(ZonesJudge, FindsNoFaultInRoundedCells) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 20; ++round) {
    std::vector<Point> points;
    for (int i = 0; i < 25; ++i) {
      const auto coordinate = [&] { return static_cast<double>(random() % 64) / (round < 10 ? 4 : 3); };
      points.push_back({coordinate(), coordinate()});
    }
    const Box box({-3, -3}, {24, 24});
    RegionSet frame{{{-3, -3}, {24, -3}, {24, 24}, {-3, 24}}, {4}, {1}};
    FeatureSet rows;
    for (const auto& cell : voronoi_cells(points, box)) {
      std::vector<Point> ring;
      for (const RationalPoint& v : cell) ring.push_back({round_into_domain(v.x), round_into_domain(v.y)});
      std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), lexicographically_less), ring.end());
      rows.regions.points.insert(rows.regions.points.end(), ring.begin(), ring.end());
      if (!ring.empty()) {
        rows.regions.contour_ends.push_back(static_cast<std::uint32_t>(rows.regions.points.size()));
        rows.regions.polygon_ends.push_back(static_cast<std::uint32_t>(rows.regions.contour_ends.size()));
      }
      rows.keys.push_back({static_cast<std::uint32_t>(rows.keys.size()), no_feature});
      rows.feature_ends.push_back(static_cast<std::uint32_t>(rows.regions.polygon_ends.size()));
    }
    const ZoneObjects objects(ShapeFeatures{{{}, {}, points}, {}, {}, {}});
    const JudgedZones zones{objects, frame, rows, rows.keys};
    const auto uncovered = check_zone_cover(zones, {});
    EXPECT_FALSE(uncovered) << uncovered->what;
    ZoneDistanceBounds bounds;
    bounds.epsilon = 8 * zone_unit(zones);
    ZoneDistanceMeasures measures;
    const auto further = check_zone_distances(zones, bounds, &measures);
    EXPECT_FALSE(further) << further->what;
    EXPECT_GT(measures.epsilon, 0);
    EXPECT_GT(measures.exactly, 0u);
    EXPECT_FALSE(check_voronoi(points, box, rows, 0));
  }
}

}  // namespace
}  // namespace oblast::verify
