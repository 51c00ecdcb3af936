// Small cases of proximity zones whose answers are known. Each is also judged by verify/ (zone_trial.h).
#include <gtest/gtest.h>
#include <oblast/error.h>
#include <oblast/locator.h>
#include <oblast/measure.h>
#include <oblast/wkt.h>

#include <cmath>

#include "generators/random.h"
#include "zones/zone_trial.h"

namespace oblast::testing {
namespace {

ZoneQuestion of_points(std::vector<Point> points) {
  ZoneQuestion question;
  question.points = std::move(points);
  return question;
}
ZoneQuestion of_polygons(const std::string& wkt) {
  ZoneQuestion question;
  question.regions = read_wkt(wkt);
  return question;
}
ZoneQuestion of_lines(const std::vector<std::vector<Point>>& lines) {
  ZoneQuestion question;
  for (const auto& line : lines) question.add_line(line);
  return question;
}

/// The zones, which keep every promise.
FeatureSet zones_of(const ZoneQuestion& question, ZoneStatistics* statistics = nullptr) {
  const auto failure = run_zone_trial(question, {4, 300, true});
  EXPECT_FALSE(failure) << to_text(failure->broken) << ": " << failure->what;
  ZoneOptions options = question.options;
  options.statistics = statistics;
  return zones(question.view(), question.frame, options);
}

RegionSet row(const FeatureSet& rows, std::uint32_t r) {
  const FeatureView view = rows;
  RegionSet regions;
  for (std::uint32_t p = view.feature_begin(r); p < view.feature_end(r); ++p) {
    for (const std::span<const Point> contour : rows.regions.polygon(p).contours()) {
      regions.points.insert(regions.points.end(), contour.begin(), contour.end());
      regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
    }
    regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
  }
  return regions;
}

double area_of(const FeatureSet& rows, std::uint32_t r) { return area(row(rows, r)); }

bool has_vertex(const RegionSet& regions, const Point& p) {
  return std::find(regions.points.begin(), regions.points.end(), p) != regions.points.end();
}

TEST(Zones, TwoPointsArePartedByTheirBisector) {
  const FeatureSet rows = zones_of(of_points({{0, 0}, {10, 0}}));
  EXPECT_EQ(row(rows, 0), read_wkt("POLYGON ((-1 -1, 5 -1, 5 1, -1 1, -1 -1))"));
  EXPECT_EQ(row(rows, 1), read_wkt("POLYGON ((5 -1, 11 -1, 11 1, 5 1, 5 -1))"));
}

TEST(Zones, FourPointsOfASquareMeetAtItsMiddle) {
  const FeatureSet rows = zones_of(of_points({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  for (std::uint32_t r = 0; r < 4; ++r) {
    EXPECT_EQ(row(rows, r).points.size(), 4U);
    EXPECT_TRUE(has_vertex(row(rows, r), {1, 1}));
  }
}

TEST(Zones, AllPointsOfACircleMeetAtItsCentre) {
  ZoneQuestion question;
  for (const auto& [x, y] : {std::pair(3.0, 4.0), {4.0, 3.0}, {5.0, 0.0}, {0.0, 5.0}})
    for (const double i : {1.0, -1.0})
      for (const double k : {1.0, -1.0}) question.points.push_back({i * x, k * y});
  const FeatureSet rows = zones_of(question);  // (5, 0) and (0, 5) are there twice, with either sign
  int empty = 0;
  for (std::uint32_t r = 0; r < rows.size(); ++r) {
    empty += row(rows, r).empty();
    EXPECT_NE(row(rows, r).empty(), has_vertex(row(rows, r), {0, 0})) << r;
  }
  EXPECT_EQ(empty, 4);
}

TEST(Zones, CollinearPointsHaveStrips) {
  const FeatureSet rows = zones_of(of_points({{0, 0}, {4, 0}, {2, 0}, {10, 0}}));
  EXPECT_EQ(area_of(rows, 0), 4);
  EXPECT_EQ(area_of(rows, 1), 8);
  EXPECT_EQ(area_of(rows, 2), 4);
  EXPECT_EQ(area_of(rows, 3), 8);
}

TEST(Zones, OfEqualPointsTheLowerNumberCounts) {
  const FeatureSet rows = zones_of(of_points({{0, 0}, {1, 1}, {0, 0}, {-0.0, 0}}));
  EXPECT_FALSE(row(rows, 0).empty());
  EXPECT_TRUE(row(rows, 2).empty());
  EXPECT_TRUE(row(rows, 3).empty());
}

TEST(Zones, ASinglePlaceHasAllOfTheFrame) {
  EXPECT_EQ(row(zones_of(of_points({{3, 3}})), 0), read_wkt("POLYGON ((2 2, 4 2, 4 4, 2 4, 2 2))"));
}

TEST(Zones, SquaresSideBySide) {
  ZoneStatistics statistics;
  const FeatureSet rows =
      zones_of(of_polygons("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1)), ((3 0, 4 0, 4 1, 3 1)))"), &statistics);
  EXPECT_NEAR(area_of(rows, 0), 2.4 * 1.8, 1e-4);
  EXPECT_NEAR(area_of(rows, 1), 2.4 * 1.8, 1e-4);
  EXPECT_LE(statistics.error, 4e-5);
  EXPECT_GT(statistics.rounds, 1U);
}

TEST(Zones, ParcelsThatTouchArePartedWhereTheyMeet) {
  const FeatureSet rows = zones_of(of_polygons("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1)), ((1 0, 2 0, 2 1, 1 1)))"));
  for (const std::uint32_t r : {0U, 1U}) {
    EXPECT_NEAR(area_of(rows, r), 1.2 * 1.4, 1e-9);
    EXPECT_TRUE(has_vertex(row(rows, r), {1, 0}));
    EXPECT_TRUE(has_vertex(row(rows, r), {1, 1}));
  }
}

TEST(Zones, CornersThatTouch) {
  const FeatureSet rows = zones_of(of_polygons("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1)), ((1 1, 2 1, 2 2, 1 2)))"));
  EXPECT_NEAR(area_of(rows, 0), area_of(rows, 1), 1e-4);
  EXPECT_TRUE(has_vertex(row(rows, 0), {1, 1}));
  EXPECT_TRUE(has_vertex(row(rows, 1), {1, 1}));
}

TEST(Zones, LinesThatCross) {
  const FeatureSet rows = zones_of(of_lines({{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}}));
  for (const std::uint32_t r : {0U, 1U}) {
    EXPECT_NEAR(area_of(rows, r), 0.72, 1e-4);
    EXPECT_TRUE(has_vertex(row(rows, r), {0.5, 0.5}));
  }
}

TEST(Zones, ALineBesideALine) {
  const FeatureSet rows = zones_of(of_lines({{{0, 0}, {10, 0}}, {{0, 1}, {10, 1}}}));
  EXPECT_NEAR(area_of(rows, 0), 12 * 1.5, 1e-3);
  EXPECT_NEAR(area_of(rows, 1), 12 * 1.5, 1e-3);
}

TEST(Zones, ThePlacesAroundASharedEndArePartedByTheBisector) {
  const FeatureSet rows = zones_of(of_lines({{{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}}));
  EXPECT_NEAR(area_of(rows, 0), area_of(rows, 1), 1e-4);
  const Locator first(row(rows, 0)), second(row(rows, 1));
  EXPECT_EQ(first.locate({-0.04, -0.06}), Location::inside);
  EXPECT_EQ(second.locate({-0.06, -0.04}), Location::inside);
  EXPECT_TRUE(has_vertex(row(rows, 0), {0, 0}));
}

TEST(Zones, OfEqualLinesTheLowerNumberCounts) {
  const FeatureSet rows = zones_of(of_lines({{{0, 0}, {1, 0}}, {{1, 0}, {0, 0}}, {{0, 3}, {1, 3}}}));
  EXPECT_FALSE(row(rows, 0).empty());
  EXPECT_TRUE(row(rows, 1).empty());
}

TEST(Zones, PolygonsThatOverlapBelongToTheLowerNumber) {
  const FeatureSet rows = zones_of(of_polygons("MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2)), ((1 0, 3 0, 3 2, 1 2)))"));
  const Locator first(row(rows, 0)), second(row(rows, 1));
  EXPECT_EQ(first.locate({1.5, 1}), Location::inside);
  EXPECT_EQ(first.locate({2, 1}), Location::boundary);
  EXPECT_EQ(second.locate({2.5, 1}), Location::inside);
}

TEST(Zones, PolygonsInPolygons) {
  const std::string outer = "((0 0, 9 0, 9 9, 0 9))", inner = "((3 3, 6 3, 6 6, 3 6))";
  const FeatureSet covered = zones_of(of_polygons("MULTIPOLYGON (" + outer + ", " + inner + ")"));
  EXPECT_TRUE(row(covered, 1).empty());
  const FeatureSet inside = zones_of(of_polygons("MULTIPOLYGON (" + inner + ", " + outer + ")"));
  EXPECT_EQ(row(inside, 0), read_wkt("POLYGON " + inner));
  const FeatureSet equal = zones_of(of_polygons("MULTIPOLYGON (" + inner + ", " + inner + ")"));
  EXPECT_TRUE(row(equal, 1).empty());
}

TEST(Zones, LinesAndPointsWithinPolygonsDoNotCount) {
  ZoneQuestion question = of_polygons("POLYGON ((0 0, 9 0, 9 9, 0 9))");
  question.add_line(std::vector<Point>{{1, 1}, {2, 2}});
  question.points = {{5, 5}, {9, 3}, {9, 9}, {20, 5}};
  question.region_rows = {3};
  question.line_rows = {0};
  question.point_rows = {1, 2, 4, 5};
  const FeatureSet rows = zones_of(question);
  for (const std::uint32_t r : {0U, 1U, 2U, 4U}) EXPECT_TRUE(row(rows, r).empty()) << r;
  EXPECT_FALSE(row(rows, 5).empty());
}

TEST(Zones, PointsOnLinesDoNotCount) {
  ZoneQuestion question = of_lines({{{0, 0}, {8, 4}}});
  question.points = {{2, 1}, {8, 4}, {4, 4}};
  const FeatureSet rows = zones_of(question);
  EXPECT_TRUE(row(rows, 1).empty());
  EXPECT_TRUE(row(rows, 2).empty());
  EXPECT_FALSE(row(rows, 3).empty());
}

TEST(Zones, ALineThroughAPolygonComesOutOnBothSides) {
  ZoneQuestion question = of_polygons("POLYGON ((0 0, 4 0, 4 4, 0 4))");
  question.add_line(std::vector<Point>{{-3, 2}, {7, 2}});
  const FeatureSet rows = zones_of(question);
  EXPECT_EQ(row(rows, 1).polygon_ends.size(), 2U);
  EXPECT_TRUE(has_vertex(row(rows, 1), {0, 2}));
  EXPECT_TRUE(has_vertex(row(rows, 1), {4, 2}));
}

TEST(Zones, SeveralShapesMayBeOneObject) {
  ZoneQuestion question = of_points({{0, 0}, {1, 0}, {2, 0}});
  question.point_rows = {0, 1, 0};
  const FeatureSet rows = zones_of(question);
  EXPECT_EQ(rows.size(), 2U);
  EXPECT_EQ(row(rows, 0).polygon_ends.size(), 2U);
}

TEST(Zones, WithinAFrame) {
  ZoneQuestion question = of_points({{0, 0}, {10, 0}, {100, 0}});
  question.frame = read_wkt("POLYGON ((2 -1, 8 -1, 8 1, 2 1, 2 -1), (4 -0.5, 4 0.5, 6 0.5, 6 -0.5, 4 -0.5))");
  const FeatureSet rows = zones_of(question);
  EXPECT_EQ(area_of(rows, 0), 5);
  EXPECT_EQ(area_of(rows, 1), 5);
  EXPECT_TRUE(row(rows, 2).empty());
  question.frame = read_wkt("POLYGON ((90 1, 91 1, 91 2, 90 1))");
  EXPECT_EQ(row(zones_of(question), 2), question.frame);
}

TEST(Zones, UpToADistance) {
  ZoneQuestion question = of_points({{0, 0}, {1, 0}, {10, 0}});
  question.options.distance = 1;
  const FeatureSet rows = zones_of(question);
  const double pi = std::acos(-1.0);
  // Of two discs whose centres are as far apart as they are wide, each keeps its half.
  EXPECT_NEAR(area_of(rows, 0), 2 * pi / 3 + std::sqrt(3) / 4, 1e-2);
  EXPECT_NEAR(area_of(rows, 1), area_of(rows, 0), 1e-3);
  EXPECT_NEAR(area_of(rows, 2), pi, 1e-2);
}

TEST(Zones, OfNothing) {
  EXPECT_EQ(zones({}).size(), 0U);
  ZoneQuestion question = of_polygons("POLYGON ((0 0, 1 1, 2 2, 0 0))");  // without area
  question.points = {{5, 5}};
  question.add_line(std::vector<Point>{{3, 3}, {3, 3}});
  const FeatureSet rows = zones_of(question);
  EXPECT_TRUE(row(rows, 0).empty());
  EXPECT_FALSE(row(rows, 1).empty());  // a line of no length is a point
  question.points.clear();
  question.line_points.clear();
  question.line_ends.clear();
  const FeatureSet none = zones(question.view());  // no object has a place, so no zone has one
  EXPECT_EQ(none.size(), 1U);
  EXPECT_TRUE(none.regions.empty());
}

TEST(Zones, RowsInAnotherOrderHaveTheSameZones) {
  generators::Random random(1);
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) points.push_back({random.in(0, 9), random.in(0, 9)});
  const FeatureSet rows = zones_of(of_points(points));
  std::reverse(points.begin(), points.end());
  const FeatureSet reversed = zones_of(of_points(points));
  for (std::uint32_t r = 0; r < rows.size(); ++r) EXPECT_EQ(row(rows, r), row(reversed, 299 - r));
}

TEST(Zones, AFinerToleranceTakesMoreSites) {
  ZoneQuestion question = of_polygons("MULTIPOLYGON (((0 0, 5 1, 1 5)), ((6 6, 9 5, 8 9)), ((0 9, 2 6, 3 8)))");
  std::uint64_t sites = 0;
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
    ZoneStatistics statistics;
    question.options.tolerance = tolerance;
    zones_of(question, &statistics);
    EXPECT_LE(statistics.error, tolerance);
    EXPECT_EQ(statistics.tolerance, tolerance);
    EXPECT_GT(statistics.sites, sites);
    sites = statistics.sites;
  }
}

template <class Call>
ErrorCode code_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(Zones, OptionsOutOfRange) {
  const ZoneQuestion question = of_points({{0, 0}, {1, 0}});
  const auto code = [&](auto change) {
    ZoneOptions options;
    change(options);
    return code_of([&] { zones(question.view(), {}, options); });
  };
  EXPECT_EQ(code([](ZoneOptions& o) { o.tolerance = -1; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](ZoneOptions& o) { o.tolerance = NAN; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](ZoneOptions& o) { o.relative_tolerance = 0.2; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](ZoneOptions& o) { o.relative_tolerance = 1e-13; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](ZoneOptions& o) { o.distance = 0; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](ZoneOptions& o) { o.distance = NAN; }), ErrorCode::bad_option);
  EXPECT_EQ(code([](ZoneOptions& o) { o.threads = -1; }), ErrorCode::bad_option);
}

TEST(Zones, InputThatIsRefused) {
  ZoneQuestion question = of_points({{0, 0}, {NAN, 0}});
  EXPECT_EQ(code_of([&] { zones(question.view()); }), ErrorCode::not_finite);
  question.points = {{0x1p299, 0}, {-0x1p299, 0}};
  EXPECT_EQ(code_of([&] { zones(question.view()); }), ErrorCode::bad_option);
  question.points = {{0, 0}};
  question.point_rows = {1, 2};
  EXPECT_EQ(code_of([&] { zones(question.view()); }), ErrorCode::bad_option);
  question.point_rows.clear();
  question.frame = {{{0, 0}, {1, 0}, {1, INFINITY}}, {3}, {1}};
  EXPECT_EQ(code_of([&] { zones(question.view(), question.frame); }), ErrorCode::not_finite);
}

TEST(Zones, CallsCanBeCancelledAndLimited) {
  generators::Random random(1);
  std::vector<Point> points;
  for (int i = 0; i < 50000; ++i) points.push_back({random.in(0, 9), random.in(0, 9)});
  const ZoneQuestion question = of_points(points);
  ZoneOptions options;
  options.progress = [](Stage, double) { return false; };
  EXPECT_EQ(code_of([&] { zones(question.view(), {}, options); }), ErrorCode::cancelled);
  options.progress = {};
  options.most_bytes = 1 << 20;
  EXPECT_EQ(code_of([&] { zones(question.view(), {}, options); }), ErrorCode::memory_limit);
}

}  // namespace
}  // namespace oblast::testing
