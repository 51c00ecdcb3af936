#include <gtest/gtest.h>
#include <oblast/buffer.h>
#include <oblast/locator.h>
#include <oblast/measure.h>
#include <oblast/overlay.h>
#include <oblast/wkt.h>

#include <cmath>
#include <limits>

#include "buffer/directions.h"
#include "buffer/wkt_shapes.h"
#include "generators/random.h"

namespace oblast::testing {
namespace {

constexpr double pi = 3.141592653589793;

RegionSet zone(const std::string& wkt, double distance, const BufferOptions& options = {}) {
  return buffer(shapes_from_wkt(wkt).view(), distance, options);
}

BufferOptions fine() {
  BufferOptions options;
  options.tolerance = 1e-6;
  return options;
}

TEST(Buffer, AreaOfASquare) {
  EXPECT_NEAR(area(zone("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))", 1, fine())), 140 + pi, 1e-4);
  EXPECT_EQ(zone("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))", -1), read_wkt("POLYGON ((1 1, 9 1, 9 9, 1 9, 1 1))"));
  EXPECT_EQ(zone("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))", -5), RegionSet{});
}

TEST(Buffer, MitresAndBevelsHaveNoVerticesAlongEdges) {
  BufferOptions options;
  options.join = Join::mitre;
  EXPECT_EQ(zone("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))", 1, options),
            read_wkt("POLYGON ((-1 -1, 11 -1, 11 11, -1 11, -1 -1))"));
  options.join = Join::bevel;
  EXPECT_EQ(zone("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))", 1, options),
            read_wkt("POLYGON ((-1 0, 0 -1, 10 -1, 11 0, 11 10, 10 11, 0 11, -1 10, -1 0))"));
}

TEST(Buffer, AMitreIsCutAtItsLimit) {
  BufferOptions options;
  options.join = Join::mitre;
  // The tip of a right angle is sqrt(2) away.
  options.mitre_limit = 1.42;
  EXPECT_DOUBLE_EQ(area(zone("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))", 1, options)), 9);
  options.mitre_limit = 1;
  const double cut =
      (std::sqrt(2) - 1) * (std::sqrt(2) - 1);  // of each tip: a triangle of this height, at a right angle
  EXPECT_NEAR(area(zone("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))", 1, options)), 9 - 4 * cut, 1e-12);
}

TEST(Buffer, CapsOfALine) {
  BufferOptions options = fine();
  EXPECT_NEAR(area(zone("LINESTRING (0 0, 10 0)", 1, options)), 20 + pi, 1e-4);
  options.cap = Cap::square;
  EXPECT_EQ(zone("LINESTRING (0 0, 10 0)", 1, options), read_wkt("POLYGON ((-1 -1, 11 -1, 11 1, -1 1, -1 -1))"));
  options.cap = Cap::flat;
  EXPECT_EQ(zone("LINESTRING (0 0, 10 0)", 1, options),
            read_wkt("POLYGON ((0 -1, 10 -1, 10 0, 10 1, 0 1, 0 0, 0 -1))"));
}

TEST(Buffer, SidesOfALine) {
  BufferOptions options;
  options.side = Side::left;
  EXPECT_EQ(zone("LINESTRING (0 0, 10 0)", 1, options), read_wkt("POLYGON ((0 0, 10 0, 10 1, 0 1, 0 0))"));
  options.side = Side::right;
  EXPECT_EQ(zone("LINESTRING (0 0, 10 0)", 1, options), read_wkt("POLYGON ((0 -1, 10 -1, 10 0, 0 0, 0 -1))"));
  // A closed line, counter-clockwise: outside of it is on its right.
  EXPECT_NEAR(area(zone("LINESTRING (0 0, 10 0, 10 10, 0 10, 0 0)", 1, options)), 40 + pi, 0.05);
  options.side = Side::left;
  EXPECT_DOUBLE_EQ(area(zone("LINESTRING (0 0, 10 0, 10 10, 0 10, 0 0)", 1, options)), 36);
}

// Two strips of width 2 cross: their sides meet in the corners of a square.
TEST(Buffer, StatisticsCountIntersections) {
  BufferStatistics statistics;
  BufferOptions options;
  options.cap = Cap::flat;
  const RegionSet without = zone("MULTILINESTRING ((0 0, 10 0), (5 -5, 5 5))", 1, options);
  options.statistics = &statistics;
  EXPECT_EQ(zone("MULTILINESTRING ((0 0, 10 0), (5 -5, 5 5))", 1, options), without);
  EXPECT_EQ(statistics.overlay.intersections, 4);
  EXPECT_GE(statistics.overlay.rounds, 1);
  EXPECT_EQ(statistics.overlay.output_vertices, without.points.size());
  zone("LINESTRING (0 0, 10 0)", 1, options);
  EXPECT_EQ(statistics.overlay.intersections, 0);
}

TEST(Buffer, PointsByTheirCaps) {
  BufferOptions options = fine();
  EXPECT_NEAR(area(zone("MULTIPOINT (0 0, 10 0, 10 0)", 1, options)), 2 * pi, 1e-4);
  options.cap = Cap::square;
  EXPECT_DOUBLE_EQ(area(zone("POINT (0 0)", 1, options)), 4);
  options.cap = Cap::flat;
  EXPECT_TRUE(zone("POINT (0 0)", 1, options).empty());
  // A line of equal points is a point.
  EXPECT_NEAR(area(zone("LINESTRING (5 5, 5 5)", 1, fine())), pi, 1e-4);
}

TEST(Buffer, NegativeDistancesLeaveOutLinesAndPoints) {
  EXPECT_TRUE(zone("GEOMETRYCOLLECTION (POINT (0 0), LINESTRING (0 0, 1 1))", -1).empty());
  EXPECT_EQ(area(zone("GEOMETRYCOLLECTION (POINT (2 2), POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)))", -1)), 4);
}

TEST(Buffer, HolesCloseAndShrink) {
  const std::string ring = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (3 3, 3 7, 7 7, 7 3, 3 3))";
  const RegionSet narrow = zone(ring, 1);
  ASSERT_EQ(narrow.contour_ends.size(), 2);
  EXPECT_DOUBLE_EQ(std::fabs(signed_area(narrow.view().contours_between(1, 2))), 4);
  EXPECT_EQ(zone(ring, 2.5).contour_ends.size(), 1);
}

TEST(Buffer, ModesKeepTheirSide) {
  const OwnedShapes shapes = shapes_from_wkt("POLYGON ((0 0, 7 1, 9 8, 3 5, -2 9, 0 0))");
  BufferOptions inside, outside;
  inside.mode = BufferMode::inside;
  outside.mode = BufferMode::outside;
  for (const double distance : {0.5, 2.0, -0.5}) {
    const RegionSet in = buffer(shapes.view(), distance, inside), out = buffer(shapes.view(), distance, outside);
    // Of a negative distance the zone is what is further away, so `inside` leaves more of the regions.
    EXPECT_TRUE(overlay(distance > 0 ? in : out, distance > 0 ? out : in, Operation::difference).empty());
    EXPECT_LT(std::fabs(area(in) - area(out)), 0.02 * std::fabs(distance) * 40);
  }
}

TEST(Buffer, NothingWithinTheDistanceIsMissedOutside) {
  const OwnedShapes shapes = shapes_from_wkt(
      "GEOMETRYCOLLECTION (POLYGON ((0 0, 7 1, 9 8, 3 5, -2 9, 0 0), (2 2, 3 4, 4 3, 2 2)), LINESTRING (12 3, 15 -4, "
      "15 9), "
      "POINT (20 3))");
  generators::Random random(1);
  for (const double distance : {1e-3, 0.7, 30.0}) {
    BufferOptions options;
    options.mode = BufferMode::outside;
    options.tolerance = 0.05;
    const RegionSet found = buffer(shapes.view(), distance, options);
    const Locator locator(found);
    std::vector<Point> points;
    std::vector<Point> vertices = shapes.regions.points;
    vertices.insert(vertices.end(), shapes.line_points.begin(), shapes.line_points.end());
    vertices.push_back(shapes.points[0]);
    for (int k = 0; k < 400'000; ++k) {
      const Point v = vertices[static_cast<std::size_t>(random.below(static_cast<int>(vertices.size())))];
      const double angle = random.in(0, 2 * pi);
      // Rounded towards the vertex, so that the point is not further away than the distance.
      const double away = distance * (random.one_in(2) ? 1 - 0x1p-50 : random.unit());
      points.push_back({v.x + away * std::cos(angle), v.y + away * std::sin(angle)});
    }
    std::size_t missed = 0;
    for (const Point& p : points) missed += locator.locate(p) == Location::outside;
    EXPECT_EQ(missed, 0) << distance;
  }
}

TEST(Buffer, ManyShortEdgesNeedFewPieces) {
  // A coast: 20,000 short edges along a circle.
  OwnedShapes coast;
  generators::Random random(7);
  for (int i = 0; i < 20'000; ++i) {
    const double angle = 2 * pi * i / 20'000, radius = 100 + random.unit();
    coast.regions.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  coast.regions.contour_ends = {20'000};
  coast.regions.polygon_ends = {1};
  BufferStatistics statistics;
  BufferOptions options;
  options.statistics = &statistics;
  const RegionSet found = buffer(coast.view(), 50, options);
  EXPECT_GT(statistics.closed_pockets, 100);
  EXPECT_LT(statistics.corners, 2'000);
  EXPECT_NEAR(area(found), pi * 151 * 151, pi * 151 * 151 * 0.01);
}

TEST(Buffer, ARowIsTheZoneOfItsShapes) {
  const OwnedShapes shapes = shapes_from_wkt(
      "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)), POLYGON ((3 3, 8 3, 8 8, 3 8, 3 3)), LINESTRING (0 9, "
      "9 9), "
      "POINT (5 5))");
  const double distances[] = {1, -0.5, 2, 0.25};
  const FeatureSet rows = buffer_rows({shapes.view(), {}, {}, {}}, distances);
  ASSERT_EQ(rows.size(), 4);
  EXPECT_NEAR(area(rows.regions),
              area(zone("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", 1)) + 16 + area(zone("LINESTRING (0 9, 9 9)", 2)) +
                  area(zone("POINT (5 5)", 0.25)),
              1e-9);
  EXPECT_EQ(rows.keys[2], (FeatureKey{2, no_feature}));
}

void expect_bad_option(const BufferOptions& options, double distance = 1) {
  try {
    zone("POINT (1 1)", distance, options);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_option) << error.what();
  }
}

TEST(Buffer, OptionsOutOfRangeAreErrors) {
  const double infinity = std::numeric_limits<double>::infinity();
  expect_bad_option({}, infinity);
  expect_bad_option({}, std::nan(""));
  expect_bad_option({}, 1e89 * 100);
  BufferOptions options;
  options.tolerance = 0;
  expect_bad_option(options);
  options = {}, options.tolerance = 0.51;
  expect_bad_option(options);
  options = {}, options.mitre_limit = 0.99;
  expect_bad_option(options);
  options = {}, options.absolute_tolerance = -1;
  expect_bad_option(options);
  options = {}, options.join = static_cast<Join>(17);
  expect_bad_option(options);
  options = {}, options.threads = -1;
  expect_bad_option(options);
}

TEST(Buffer, AFaultyCoordinateIsNamed) {
  OwnedShapes shapes = shapes_from_wkt("LINESTRING (0 0, 1 1, 2 2)");
  shapes.line_points[1].y = std::nan("");
  try {
    buffer(shapes.view(), 1);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::not_finite);
    EXPECT_EQ(error.place().operand, 1);
    EXPECT_EQ(error.place().vertex, 1);
  }
}

TEST(Buffer, RowNumbersMustFit) {
  const OwnedShapes shapes = shapes_from_wkt("MULTIPOINT (0 0, 1 1)");
  const double distances[] = {1};
  const std::uint32_t one[] = {0}, beyond[] = {0, 1};
  EXPECT_THROW(buffer_rows({shapes.view(), {}, {}, one}, distances), Error);
  EXPECT_THROW(buffer_rows({shapes.view(), {}, {}, beyond}, distances), Error);
  EXPECT_THROW(buffer_rows({shapes.view(), {}, {}, {}}, distances), Error);
}

TEST(Directions, AFinerLevelHoldsTheCoarserOne) {
  const internal::buffering::Directions coarse(3), fine(6);
  for (std::size_t k = 0; k < coarse.count(); ++k) {
    EXPECT_EQ(coarse[k], fine[8 * k]);
    EXPECT_NEAR(std::hypot(coarse[k].x, coarse[k].y), 1, 1e-15);
  }
}

TEST(Directions, BetweenLeavesOutTheEnds) {
  const internal::buffering::Directions directions(1);  // 8
  EXPECT_EQ(directions.between({1, 0}, {0, 1}).count, 1);
  EXPECT_EQ(directions.between({1, 0}, {-1, 0}).count, 3);
  EXPECT_EQ(directions.between({1, 0}, {1, 0}).count, 0);
  EXPECT_EQ(directions.between({0, -1}, {0.6, -0.8}).count, 0);
  EXPECT_EQ(directions.between({0.6, -0.8}, {0.6, 0.8}).count, 3);
}

}  // namespace
}  // namespace oblast::testing
