// `oblast zones`: shapes, objects of a column, frame, lengths, coordinate systems, attributes, picture.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;

class Zones : public ::testing::Test {
 protected:
  Zones() {
    write_file(frame_, "POLYGON ((0 0, 20 0, 20 10, 0 10, 0 0))");
    write_file(metres_, "SRID=3035;POLYGON ((0 0, 20 0, 20 10, 0 10, 0 0))");
  }
  ProgramRun run(const std::string& input, const Words& more) {
    Words words{"zones", "-", "-o", out_, "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words, input);
  }
  /// The areas of the zones of these shapes, in order. They are a coverage.
  std::vector<double> areas(const std::string& input, const Words& more) {
    const ProgramRun done = run(input, more);
    EXPECT_EQ(done.code, 0) << done.err;
    return areas_of_coverage();
  }
  std::vector<double> areas_of_coverage() {
    EXPECT_EQ(oblast_program({"check", "--coverage", out_}).code, 0);
    std::vector<double> areas;
    for (const std::string& row : rows_of(out_).rows) areas.push_back(std::stod(row.substr(row.find("area=") + 5)));
    return areas;
  }
  /// A call that is refused, with this in its message.
  void refused(const std::string& input, const Words& more, const std::string& message, int code = 2) {
    const ProgramRun done = run(input, more);
    EXPECT_EQ(done.code, code) << done.err;
    EXPECT_TRUE(contains(done.err, message)) << done.err;
  }

  Folder folder_;
  std::string out_ = folder_.path("out.geojson"), frame_ = folder_.path("frame.wkt"),
              metres_ = folder_.path("metres.wkt");
};

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double slack) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], slack) << i;
}

TEST_F(Zones, PointsShareTheFrameByTheirBisectors) {
  expect_near(areas("POINT (5 5)\nPOINT (9 5)", {"--within", frame_}), {70, 130}, 1e-9);
  expect_near(areas("POINT (5 5)\nPOINT (15 5)\nPOINT (100 100)", {"--within", frame_}), {100, 100, 0}, 1e-9);
  expect_near(areas("MULTIPOINT ((2 5), (18 5))\nPOINT (10 5)", {"--within", frame_}), {120, 80}, 1e-9);
}

TEST_F(Zones, LinesAndPolygonsAndPointsAreReadTogether) {
  // The middle between x = 4 and x = 8; then between a line and a point.
  expect_near(areas("POLYGON ((0 0, 4 0, 4 10, 0 10, 0 0))\nLINESTRING (8 -90, 8 90)", {"--within", frame_}), {60, 140},
              0.01);
  // Places as far from (10, 10) as from the line y = 0: y = 5 + (x - 10)^2 / 20.
  const double above = 100 - 2 * 1000.0 / 60;
  expect_near(areas("LINESTRING (-90 0, 110 0)\nPOINT (10 10)", {"--within", frame_, "--tolerance", "0.001 units"}),
              {200 - above, above}, 0.2);
}

TEST_F(Zones, WithoutAFrameTheyFillABoxWithAMargin) {
  expect_near(areas("POINT (0 0)\nPOINT (10 0)", {}), {12, 12}, 1e-9);  // 12 x 2
  // The box has room for all places within the distance: half of two discs and not of what both have.
  const double lens = 20000 * std::acos(0.05) - 5 * std::sqrt(40000.0 - 100);
  const double half = std::numbers::pi * 10000 - lens / 2;
  expect_near(areas("POINT (0 0)\nPOINT (10 0)", {"--distance", "100", "--tolerance", "0.01 units"}), {half, half}, 4);
}

TEST_F(Zones, EndAtTheDistance) {
  const double disc = std::numbers::pi * 4;
  expect_near(areas("POINT (0 0)\nPOINT (10 0)", {"--distance", "2", "--tolerance", "0.01 units"}), {disc, disc}, 0.2);
  expect_near(areas("POINT (5 5)\nPOINT (15 5)", {"--within", frame_, "--distance", "100"}), {100, 100}, 1e-9);
}

TEST_F(Zones, TolerancesAreSharesPercentagesOrLengths) {
  const std::string parabola = "LINESTRING (0 0, 100 0)\nPOINT (50 60)";
  const auto with = [&](const std::string& tolerance) {
    EXPECT_EQ(run(parabola, {"--tolerance", tolerance}).code, 0) << tolerance;
    return read_file(out_);
  };
  EXPECT_EQ(with("0.001"), with("0.1%"));
  EXPECT_EQ(with("0.001"), with("0.1 units"));
  EXPECT_LT(with("0.01").size(), with("0.00001").size());
  refused(parabola, {"--tolerance", "1cm"}, "--assume-crs");
  refused(parabola, {"--tolerance", "3"}, "from 1e-12 to 0.1");
  refused(parabola, {"--tolerance", "fine"}, "write a length such as 0.1m");
  refused(parabola, {"--tolerance", "-1 units"}, "must be above 0");
  refused(parabola, {"--distance", "0"}, "must be above 0");
  refused(parabola, {"--distance", "5%"}, "write a number with a unit");
  refused(parabola, {"--distance", "far"}, "write a number with a unit");
}

TEST_F(Zones, LengthsHaveUnits) {
  const std::string two = "SRID=3035;POINT (5 5)\nSRID=3035;POINT (15 5)";
  areas(two, {"--within", metres_, "--distance", "1m"});
  const std::string one_metre = read_file(out_);
  areas(two, {"--within", metres_, "--distance", "100cm"});
  EXPECT_EQ(read_file(out_), one_metre);
  refused(two, {"--distance", "3 leagues"}, "leagues is not a unit");
  refused(two, {"--within", frame_}, "coordinate system", 1);
}

TEST_F(Zones, DegreesAreExplained) {
  const std::string two = "SRID=4326;POINT (5 60)\nSRID=4326;POINT (5.1 60)";
  refused(two, {}, "--crs auto");
  refused(two, {"--distance", "1km"}, "the nearest object needs a projected system");
  refused(two, {"--crs", "EPSG:4326"}, "name a projected system");
  refused(two, {"--crs", "auto", "--tolerance", "1e-6 degrees"}, "units of length");
  refused("POINT (5 45)", {"--crs", "auto"}, "--assume-crs");
  expect_near(areas(two, {"--tolerance", "1e-6 degrees"}), {0.06 * 0.02, 0.06 * 0.02}, 1e-9);
}

TEST_F(Zones, CrsAutoMeasuresMetres) {
  for (const double latitude : {60.0, -33.0, 83.0}) {
    const std::string y = std::to_string(latitude);
    const std::string two = "SRID=4326;POINT (5 " + y + ")\nSRID=4326;POINT (6 " + y + ")";
    const ProgramRun done = run(two, {"--distance", "1km", "--crs", "auto", "--tolerance", "1m", "--area", "m2"});
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_TRUE(contains(done.err, "computed in")) << done.err;
    const double disc = std::numbers::pi * 1e6;
    EXPECT_EQ(oblast_program({"check", "--coverage", out_}).code, 0);
    const auto features = nlohmann::json::parse(read_file(out_))["features"];
    ASSERT_EQ(features.size(), 2U);
    for (const auto& feature : features)  // on the ellipsoid
      EXPECT_NEAR(feature["properties"]["m2"].get<double>(), disc, 0.02 * disc) << latitude;
  }
}

TEST_F(Zones, CrsAutoTakesTheFrameThereAndBack) {
  const std::string frame = folder_.path("degrees.wkt");
  write_file(frame, "SRID=4326;POLYGON ((4 50, 8 50, 8 52, 4 52, 4 50))");
  std::string points;
  for (int i = 0; i < 60; ++i)
    points += "SRID=4326;POINT (" + std::to_string(4 + i * 7 % 60 / 15.0) + " " + std::to_string(50 + i / 30.0) + ")\n";
  double sum = 0;
  for (const double area : areas(points, {"--within", frame, "--crs", "auto"})) sum += area;
  EXPECT_NEAR(sum, 8, 0.01) << "the long edges of the frame are straight in the other system";
}

class ZoneRows : public Zones {
 protected:
  ZoneRows() {
    write_layer(in_, {square(0, 2, R"("name":"a","kind":2,"note":null)"), square(4, 2, R"("name":"b","kind":1)"),
                      square(8, 2, R"("name":"c","kind":2,"note":"x")"), square(90, 0, R"("name":"d","kind":null)")});
    write_file(strip_, "SRID=3035;POLYGON ((0 0, 10 0, 10 2, 0 2, 0 0))");
  }
  ProgramRun rows(const Words& more) {
    Words words{"zones", in_, "-o", out_, "--overwrite", "--within", strip_};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words);
  }

  std::string in_ = folder_.path("in.geojson"), strip_ = folder_.path("strip.wkt");
};

TEST_F(ZoneRows, KeepTheirAttributes) {
  const ProgramRun done = rows({});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(contains(done.err, "1 object without a zone")) << done.err;
  EXPECT_EQ(rows_of(out_).columns, rows_of(in_).columns);
  expect_near(areas_of_coverage(), {6, 8, 6, 0}, 0.01);
  EXPECT_EQ(rows({"--select", "name", "--where", "name <> 'd'"}).code, 0);
  expect_near(areas_of_coverage(), {6, 8, 6}, 0.01);
  EXPECT_EQ(rows_of(out_).columns, "name: text");
}

TEST_F(ZoneRows, FeaturesWithTheSameValueAreOneObject) {
  EXPECT_EQ(rows({"--by", "kind", "--area", "m2"}).code, 0);
  const RowsOfFile found = rows_of(out_);
  ASSERT_EQ(found.rows.size(), 3U);
  EXPECT_TRUE(contains(found.rows[0], "kind=1 name=b note=null")) << found.rows[0];
  EXPECT_TRUE(contains(found.rows[1], "kind=2 name=a note=x")) << found.rows[1];
  EXPECT_TRUE(contains(found.rows[2], "kind=null name=d note=null")) << found.rows[2];
  expect_near(areas_of_coverage(), {8, 12, 0}, 0.01);
  const ProgramRun missing = rows({"--by", "sort"});
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(contains(missing.err, "there is no column sort; choose from name, kind, note")) << missing.err;
}

TEST_F(ZoneRows, TheFrameHasConditionsOfItsOwn) {
  const std::string frames = folder_.path("frames.geojson");
  write_layer(frames, {square(0, 4, R"("code":1)"), square(50, 4, R"("code":2)")});
  Words words{"zones", in_, "-o", out_, "--within", frames, "--where-within", "code = 1"};
  EXPECT_EQ(oblast_program(words).code, 0);
  double sum = 0;
  for (const double area : areas_of_coverage()) sum += area;
  EXPECT_NEAR(sum, 16, 1e-9);
  refused("POINT (0 0)", {"--where-within", "code = 1"}, "--within");
  write_file(strip_, "SRID=3035;LINESTRING (0 0, 10 0)");
  const ProgramRun line = rows({});
  EXPECT_EQ(line.code, 1);
  EXPECT_TRUE(contains(line.err, "there is no frame")) << line.err;
}

TEST_F(ZoneRows, OverlapsGoToTheFirst) {
  write_layer(in_, {square(0, 2, R"("name":"a")"), square(1, 2, R"("name":"b")"), square(0.5, 1, R"("name":"c")")});
  EXPECT_EQ(rows({}).code, 0);
  const std::vector<double> found = areas_of_coverage();
  expect_near(found, {4, 16, 0}, 0.01);
}

TEST_F(ZoneRows, PicturesColourTheZonesAndDrawTheObjects) {
  const std::string picture = folder_.path("picture.svg");
  EXPECT_EQ(rows({"--svg", picture}).code, 0);
  const std::string drawn = read_file(picture);
  EXPECT_TRUE(contains(drawn, "zones of in.geojson"));
  EXPECT_TRUE(contains(drawn, ">zones</text>") && contains(drawn, ">objects</text>"));
  EXPECT_TRUE(contains(drawn, "fill=\"#cfe3b4\"") && contains(drawn, "fill=\"#f6d5a8\"")) << "neighbours differ";
  EXPECT_FALSE(contains(drawn, "fill=\"#bcd8ea\"")) << "zones in a row need two colours";
  EXPECT_EQ(rows({"--svg", picture, "--colour", "name"}).code, 0);
  EXPECT_TRUE(contains(read_file(picture), ">b</text>") && contains(read_file(picture), ">objects</text>"));
}

TEST_F(Zones, SummarySaysTheBound) {
  const Words more{"--json", "-q", "--tolerance", "0.1 units"};
  const auto found = nlohmann::json::parse(run("LINESTRING (0 0, 100 0)\nPOINT (50 60)\nPOINT EMPTY", more).out);
  EXPECT_EQ(found["operands"][0]["lines"], 1);
  EXPECT_EQ(found["zones"]["objects"], 3);
  EXPECT_EQ(found["zones"]["without_zone"], 1);
  EXPECT_EQ(found["zones"]["tolerance"], 0.1);
  EXPECT_LE(found["zones"]["error"], 0.1);
  EXPECT_GT(found["zones"]["error"], 0);
  EXPECT_GT(found["zones"]["sites"], 3);
  EXPECT_LT(found["zones"]["rounding"], 1e-9);
  const ProgramRun text = run("POINT (0 0)\nPOINT (5 0)", {});
  EXPECT_TRUE(contains(text.err, "2 objects, as 2 sites in 1 round")) << text.err;
}

TEST_F(Zones, OfNothingAreNothing) {
  EXPECT_EQ(run("POINT EMPTY", {}).code, 0);
  expect_near(areas_of_coverage(), {0}, 0);
}

TEST_F(Zones, FaultsHaveTheirPlace) {
  refused("LINESTRING (0 0, 1 1e300)\nPOINT (4 4)", {}, "feature 0 (line 1), part 1, vertex 1: y is 1e+300", 1);
}

TEST_F(Zones, ThreadsChangeNothing) {
  std::string text;
  for (int i = 0; i < 200; ++i)
    text += "LINESTRING (" + std::to_string(i * 7 % 100) + " " + std::to_string(i) + ", " +
            std::to_string(i * 7 % 100 + 1) + " " + std::to_string(i + 0.5) + ")\n";
  run(text, {"--threads", "1", "--tolerance", "0.01"});
  const std::string one = read_file(out_);
  run(text, {"--threads", "2", "--tolerance", "0.01"});
  EXPECT_EQ(read_file(out_), one);
  EXPECT_EQ(run(text, {"--memory", "10KB"}).code, 1);
}

}  // namespace
}  // namespace oblast::test
