// `oblast buffer`: shapes, options, units, coordinate systems, rows.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;
constexpr double pi = std::numbers::pi;

class Buffer : public ::testing::Test {
 protected:
  ProgramRun run(const std::string& input, Words more) {
    Words words{"buffer", "-", "-o", out_, "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words, input);
  }
  /// The area of the zone of these shapes.
  double area(const std::string& input, const Words& more) {
    const ProgramRun done = run(input, more);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(oblast_program({"check", "--rows", out_}).code, 0);
    return area_of(out_);
  }
  /// A call that is refused, with this in its message.
  void refused(const std::string& input, const Words& more, const std::string& message, int code = 2) {
    const ProgramRun done = run(input, more);
    EXPECT_EQ(done.code, code) << done.err;
    EXPECT_TRUE(contains(done.err, message)) << done.err;
  }

  Folder folder_;
  std::string out_ = folder_.path("out.geojson");
};

constexpr const char* line = "LINESTRING (0 0, 100 0)";
constexpr const char* box = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))";

TEST_F(Buffer, PolygonsLinesAndPointsAreReadTogether) {
  const double of_point = pi * 4, of_line = 400 + pi * 4, of_box = 100 + 80 + pi * 4;
  EXPECT_NEAR(area("POINT (500 0)", {"--distance", "2"}), of_point, 0.04 * of_point);
  EXPECT_NEAR(area("MULTIPOINT ((500 0), 600 0, EMPTY)", {"--distance", "2"}), 2 * of_point, 0.08 * of_point);
  EXPECT_NEAR(area(line, {"--distance", "2"}), of_line, 0.5);
  EXPECT_NEAR(area("MULTILINESTRING ((0 0, 100 0), EMPTY, (0 50, 100 50))", {"--distance", "2"}), 2 * of_line, 1);
  EXPECT_NEAR(area("GEOMETRYCOLLECTION (POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0)), LINESTRING (0 50, 100 50), "
                   "GEOMETRYCOLLECTION (POINT (500 0)))",
                   {"--distance", "2"}),
              of_box + of_line + of_point, 1.5);
}

TEST_F(Buffer, OtherCommandsStillPassOverLinesAndPoints) {
  const std::string shapes = std::string(line) + "\n" + box + "\nPOINT (3 3)\n";
  const ProgramRun done = oblast_program({"union", "-", "-o", "-"}, shapes);
  EXPECT_EQ(done.code, 0);
  EXPECT_TRUE(contains(done.err, "1 line feature passed over") && contains(done.err, "1 point feature passed over"))
      << done.err;
  EXPECT_TRUE(contains(done.out, "POLYGON (((0 0, 10 0, 10 10, 0 10, 0 0)))")) << done.out;
}

TEST_F(Buffer, GdalReadsTheSameAsOurText) {
  const std::string shapes = std::string(line) + "\n" + box + "\nPOINT (300 3)\nMULTIPOINT (400 0, 420 0)\n";
  const double of_text = area(shapes, {"--distance", "3"});
  const std::string json =
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3035"}},"features":[)"
      R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[0,0],[100,0]]}},)"
      R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10],[0,10],[0,0]]]}},)"
      R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[300,3]}},)"
      R"({"type":"Feature","properties":{},"geometry":{"type":"MultiPoint","coordinates":[[400,0],[420,0]]}}]})";
  EXPECT_EQ(area(json, {"--distance", "3"}), of_text);
  EXPECT_EQ(area(json, {"--distance", "3", "-q"}), of_text);
}

TEST_F(Buffer, WellKnownBinaryIsReadToo) {
  const std::string point = "0101000000000000000000F03F0000000000000040";  // (1 2)
  const std::string straight =                                             // (0 0, 100 0)
      "010200000002000000"
      "00000000000000000000000000000000"
      "00000000000059400000000000000000";
  EXPECT_EQ(area(point, {"--distance", "3"}), area("POINT (1 2)", {"--distance", "3"}));
  EXPECT_EQ(area(straight, {"--distance", "2", "--cap", "flat"}), 400);
}

TEST_F(Buffer, NegativeDistancesShrinkPolygonsOnly) {
  EXPECT_EQ(area(box, {"--distance", "-2"}), 36);
  const ProgramRun done = run(std::string(box) + "\n" + line, {"--distance", "-2"});
  EXPECT_EQ(area_of(out_), 36);
  EXPECT_TRUE(contains(done.err, "lines and points count as nothing")) << done.err;
  const ProgramRun nothing = run(box, {"--distance", "-7"});
  EXPECT_EQ(nothing.code, 0);
  EXPECT_TRUE(contains(nothing.err, "nothing is left")) << nothing.err;
  EXPECT_TRUE(rows_of(out_).rows.empty());
}

TEST_F(Buffer, JoinsCapsAndSides) {
  EXPECT_EQ(area(box, {"--distance", "2", "--join", "mitre"}), 196);
  EXPECT_EQ(area(box, {"--distance", "2", "--join", "bevel"}), 188);
  EXPECT_LT(area("POLYGON ((0 0, 100 0, 0 1, 0 0))", {"--distance", "2", "--join", "mitre", "--mitre-limit", "1.5"}),
            area("POLYGON ((0 0, 100 0, 0 1, 0 0))", {"--distance", "2", "--join", "mitre"}));
  EXPECT_EQ(area(line, {"--distance", "2", "--cap", "flat"}), 400);
  EXPECT_EQ(area(line, {"--distance", "2", "--cap", "square"}), 416);
  EXPECT_EQ(area(line, {"--distance", "2", "--side", "left"}), 200);
  const ProgramRun right = run(line, {"--distance", "2", "--side", "right", "--svg", folder_.path("p.svg")});
  EXPECT_EQ(right.code, 0);
  EXPECT_TRUE(contains(read_file(out_), "-2")) << read_file(out_);
  EXPECT_TRUE(contains(read_file(folder_ / "p.svg"), "buffer of standard input"));
  EXPECT_TRUE(contains(run(box, {"--distance", "2", "--side", "left"}).err, "--side is for lines"));
}

TEST_F(Buffer, APictureShowsLinesAndPointsOverTheZone) {
  const std::string shapes = "LINESTRING (0 0, 50 0, 100 40)\nPOINT (20 30)\nPOINT (25 30)\n";
  const ProgramRun done = run(shapes, {"--distance", "5", "--svg", folder_.path("p.svg")});
  EXPECT_EQ(done.code, 0) << done.err;
  const std::string svg = read_file(folder_ / "p.svg");
  EXPECT_TRUE(contains(svg, "standard input: 1 line, 3 vertices</text>")) << svg;
  EXPECT_TRUE(contains(svg, "standard input: 2 points</text>")) << svg;
  const auto zone = svg.find("<g fill=\"#0f9d76\"", svg.find("<g clip-path"));
  const auto lines = svg.find("fill=\"none\" stroke=\"#1b4f77\"", zone), points = svg.find("h0M", lines);
  EXPECT_NE(zone, std::string::npos);
  EXPECT_NE(lines, std::string::npos);
  EXPECT_NE(points, std::string::npos);
}

TEST_F(Buffer, ModesBoundTheAreaFromBothSides) {
  const double disc = pi * 100;
  const Words usual{"--distance", "10", "--tolerance", "5%"};
  const auto with = [&](const std::string& mode) {
    Words words = usual;
    words.insert(words.end(), {"--mode", mode});
    return area("POINT (0 0)", words);
  };
  EXPECT_LT(with("inside"), disc);
  EXPECT_GT(with("inside"), 0.9 * disc);
  EXPECT_GT(with("outside"), disc);
  EXPECT_LT(with("outside"), 1.11 * disc);
}

TEST_F(Buffer, TolerancesAreSharesPercentagesOrLengths) {
  const auto with = [&](const std::string& tolerance) {
    EXPECT_EQ(run("POINT (0 0)", {"--distance", "10", "--tolerance", tolerance}).code, 0) << tolerance;
    return read_file(out_);
  };
  EXPECT_EQ(with("0.02"), with("2%"));
  EXPECT_EQ(with("0.02"), with("0.2 units"));
  EXPECT_LT(with("0.02").size(), with("0.0001").size());
  refused("POINT (0 0)", {"--distance", "10", "--tolerance", "0.2m"}, "--assume-crs");
  refused("POINT (0 0)", {"--distance", "10", "--tolerance", "3"}, "from 1e-9 to 0.5");
  refused("POINT (0 0)", {"--distance", "10", "--tolerance", "much"}, "write a share");
  refused("POINT (0 0)", {"--distance", "10", "--tolerance", "-1 units"}, "must be above 0");
}

TEST_F(Buffer, UnitsAreThoseOfTheCoordinatesOrGiven) {
  const std::string metres = "SRID=3035;POINT (4000000 3000000)", feet = "SRID=2263;POINT (900000 200000)";
  const double disc = area(metres, {"--distance", "1000"});
  EXPECT_NEAR(disc, pi * 1e6, 0.02 * pi * 1e6);
  for (const char* same : {"1000m", "1km", "1 km", "+1000 m", "1e3 m", "1000 metres"})
    EXPECT_DOUBLE_EQ(area(metres, {"--distance", same}), disc) << same;
  EXPECT_NEAR(area(metres, {"--distance", "1000ft"}), disc * 0.3048 * 0.3048, 1e-6 * disc);
  EXPECT_NEAR(area(feet, {"--distance", "304.8m"}), area(feet, {"--distance", "1000ft"}), 1);
  refused(metres, {"--distance", "3 leagues"}, "leagues is not a unit; choose from m, km");
  refused(metres, {"--distance", "3%"}, "no percentage");
  refused(metres, {"--distance", "3 degrees"}, "not degrees");
  refused(line, {"--distance", "3km"}, "do not say how long a unit");
}

TEST_F(Buffer, DegreesAreExplained) {
  const std::string point = "SRID=4326;POINT (5 45)";
  refused(point, {"--distance", "1km"}, "--crs auto");
  refused(point, {"--distance", "1"}, "from west to east 111 km at the equator");
  refused(point, {"--distance", "1km", "--crs", "EPSG:4326"}, "name a projected system");
  refused(point, {"--distance", "1km", "--crs", "EPSG:0"}, "not a coordinate system");
  refused(point, {"--distance", "1 degree", "--crs", "auto"}, "units of length");
  refused("POINT (5 45)", {"--distance", "1km", "--crs", "auto"}, "--assume-crs");
  EXPECT_NEAR(area(point, {"--distance", "0.1 degrees"}), pi * 0.01, 0.02 * pi * 0.01);
}

// On the ellipsoid.
double square_metres(const std::string& path) {
  const ProgramRun measured = oblast_program({"dissolve", path, "-o", "-", "--format", "geojson", "--area", "m2"});
  const auto found = nlohmann::json::parse(measured.out);
  return found["features"][0]["properties"]["m2"];
}

TEST_F(Buffer, CrsAutoMeasuresMetresAnywhere) {
  for (const char* point : {"SRID=4326;POINT (5 45)", "SRID=4326;POINT (-70.5 -33)", "SRID=4326;POINT (0 0)",
                            "SRID=4326;POINT (25 83.9)", "SRID=4326;POINT (179.999 -17)"}) {
    const ProgramRun done = run(point, {"--distance", "1km", "--crs", "auto"});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_TRUE(contains(done.err, "computed in")) << done.err;
    EXPECT_NEAR(square_metres(out_), pi * 1e6, 0.02 * pi * 1e6) << point;
    EXPECT_EQ(oblast_program({"check", "--rows", out_}).code, 0);
  }
  run("SRID=4326;MULTIPOINT (5 45, 25 55)", {"--distance", "10km", "--crs", "auto", "--by-feature"});
  EXPECT_NEAR(square_metres(out_), 2 * pi * 1e8, 0.04 * pi * 1e8);
  run("SRID=4326;POINT (5 45)", {"--distance", "2000km", "--crs", "auto"});
  const double cap = 2 * pi * 6371.0e3 * 6371.0e3 * (1 - std::cos(2000.0 / 6371));
  EXPECT_NEAR(square_metres(out_), cap, 0.02 * cap);
  run("SRID=4326;POINT (5 45)", {"--distance", "1km", "--crs", "EPSG:3035"});
  EXPECT_NEAR(square_metres(out_), pi * 1e6, 0.03 * pi * 1e6);
  refused("SRID=4326;POINT (0 89.9)", {"--distance", "50km", "--crs", "auto"}, "holds a pole", 1);
  refused("SRID=4326;MULTIPOINT (-120 0, 120 0)", {"--distance", "50km", "--crs", "auto"}, "half of the globe", 1);
  EXPECT_TRUE(contains(run("SRID=4326;POINT EMPTY", {"--distance", "1km", "--crs", "auto"}).err, "nothing is left"));
  EXPECT_TRUE(contains(run("SRID=3035;POINT (4000000 3000000)", {"--distance", "1km", "--crs", "auto"}).err,
                       "projected already"));
}

class BufferRows : public Buffer {
 protected:
  BufferRows() {
    write_layer(
        in_, {square(0, 10, R"("name":"a","width":1,"note":"x")"), square(5, 10, R"("name":"b","width":-6,"note":"y")"),
              square(90, 0, R"("name":"c","width":2.5,"note":null)")});
  }
  ProgramRun rows(Words more) {
    Words words{"buffer", in_, "-o", out_, "--overwrite", "--join", "mitre"};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words);
  }

  std::string in_ = folder_.path("in.geojson");
};

TEST_F(BufferRows, KeepTheirAttributes) {
  EXPECT_EQ(rows({"--distance", "1m", "--by-feature"}).code, 0);
  EXPECT_EQ(rows_of(out_).rows, (Lines{"name=a width=1 note=x area=144", "name=b width=-6 note=y area=144",
                                       "name=c width=2.5 note=null area=0"}));
  EXPECT_EQ(rows_of(out_).columns, rows_of(in_).columns);
  EXPECT_EQ(
      rows({"--distance", "1m", "--by-feature", "--select", "name", "--where", "name <> 'b'", "--area", "m2"}).code, 0);
  EXPECT_EQ(rows_of(out_).rows, (Lines{"name=a m2=144 area=144", "name=c m2=0 area=0"}));
}

TEST_F(BufferRows, WithoutThemAreOneAndTheAttributesAreNamed) {
  const ProgramRun done = rows({"--distance", "1"});
  EXPECT_EQ(rows_of(out_).rows, Lines{"area=204"});  // 12 x 17
  EXPECT_TRUE(contains(done.err, "3 attributes passed over: name, width and note")) << done.err;
  refused(line, {"--distance", "1", "--select", "name"}, "--by-feature");
}

TEST_F(BufferRows, DistancesOfAColumn) {
  EXPECT_EQ(rows({"--distance", "width", "--by-feature", "--select", "name"}).code, 0);
  EXPECT_EQ(rows_of(out_).rows, (Lines{"name=a area=144", "name=b area=0", "name=c area=0"}));
  EXPECT_EQ(rows({"--distance", "width"}).code, 0);
  EXPECT_EQ(rows_of(out_).rows, Lines{"area=144"});
  const ProgramRun missing = rows({"--distance", "breadth"});
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(contains(missing.err, "no column breadth") && contains(missing.err, "(width)")) << missing.err;
  const ProgramRun text = rows({"--distance", "name"});
  EXPECT_EQ(text.code, 1);
  EXPECT_TRUE(contains(text.err, "column name has text, not a number")) << text.err;
  write_layer(in_, {square(0, 10, R"("width":1)"), square(0, 10, R"("width":null)")});
  const ProgramRun null = rows({"--distance", "width"});
  EXPECT_EQ(null.code, 1);
  EXPECT_TRUE(contains(null.err, "feature 1: there is no distance in column width")) << null.err;
  EXPECT_EQ(rows({"--distance", "width", "--where", "width IS NOT NULL"}).code, 0);
}

TEST_F(Buffer, WordsThatAreNoneAreRefusedWithTheChoice) {
  refused(line, {"--distance", "1", "--join", "sharp"}, "choose round, mitre or bevel");
  refused(line, {"--distance", "1", "--cap", "butt"}, "choose round, flat or square");
  refused(line, {"--distance", "1", "--side", "north"}, "choose both, left or right");
  refused(line, {"--distance", "1", "--mode", "exact"}, "choose nearest, inside or outside");
  refused(line, {"--distance", "1", "--join", "mitre", "--mitre-limit", "0.5"}, "1 or more");
  refused(line, {"--distance", "1", "--mitre-limit", "3"}, "--join mitre");
  refused(line, {}, "--distance");
}

TEST_F(Buffer, SummarySaysTheBound) {
  Words words{"buffer", "-", "-o", folder_.path("o.gpkg"), "--distance", "10", "--tolerance", "2%", "--json", "-q"};
  const auto found = nlohmann::json::parse(oblast_program(words, std::string(line) + "\nPOINT (0 90)").out);
  EXPECT_EQ(found["operands"][0]["lines"], 1);
  EXPECT_EQ(found["operands"][0]["points"], 1);
  EXPECT_EQ(found["buffer"]["least_distance"], 10);
  EXPECT_GE(found["buffer"]["lower_factor"], 0.98);
  EXPECT_LE(found["buffer"]["upper_factor"], 1.02);
  EXPECT_GT(found["buffer"]["directions"], 4);
  EXPECT_GT(found["result"]["vertices"], 10);
}

TEST_F(Buffer, FaultsOfLinesAndPointsHaveTheirPlace) {
  refused("LINESTRING (0 0, 1 1e300)", {"--distance", "1"}, "feature 0 (line 1), part 1, vertex 1: y is 1e+300", 1);
  refused("POINT (0 0)\nPOINT (1e300 0)", {"--distance", "1"}, "feature 1 (line 2), part 1: x is 1e+300", 1);
}

TEST_F(Buffer, ThreadsChangeNothing) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "POINT (" + std::to_string(i * 7 % 100) + " " + std::to_string(i) + ")\n";
  run(text, {"--distance", "9", "--threads", "1"});
  const std::string one = read_file(out_);
  run(text, {"--distance", "9", "--threads", "2"});
  EXPECT_EQ(read_file(out_), one);
}

}  // namespace
}  // namespace oblast::test
