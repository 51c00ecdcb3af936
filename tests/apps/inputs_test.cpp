// What the program reads: layers of files, archives, folders, standard input, coordinate systems; and what it says of
// it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/program_run.h"
#include "apps/rows_support.h"

namespace oblast::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* unit_square = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))";

/// GeoJSON of one polygon with these coordinates; `crs` is the number of an EPSG code, or 0 for longitude and latitude.
std::string geojson(const std::string& ring, int crs = 0) {
  const std::string member =
      crs == 0 ? ""
               : fmt::format(R"("crs":{{"type":"name","properties":{{"name":"urn:ogc:def:crs:EPSG::{}"}}}},)", crs);
  return R"({"type":"FeatureCollection",)" + member +
         R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[)" + ring +
         "]}}]}";
}

std::string box(double x0, double y0, double x1, double y1) {
  return fmt::format("[[{0},{1}],[{2},{1}],[{2},{3}],[{0},{3}],[{0},{1}]]", x0, y0, x1, y1);
}

ProgramRun unite(const std::string& input, Words more = {}, const std::string& piped = {}) {
  Words words{"union", input, "-o", "-"};
  words.insert(words.end(), more.begin(), more.end());
  return oblast_program(words, piped);
}

/// a.gpkg with the layers a and b: a square of width 1, and one of width 2.
std::string two_layers(const Folder& folder) {
  const std::string path = folder.path("a.gpkg");
  EXPECT_EQ(oblast_program({"union", "-", "-o", path, "-q"}, unit_square).code, 0);
  EXPECT_EQ(oblast_program({"union", "-", "-o", path + ":b", "-q"}, "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))").code, 0);
  return path;
}

TEST(Layers, SeveralAreAnErrorUnlessOneIsNamed) {
  const Folder folder;
  const std::string path = two_layers(folder);
  const ProgramRun none = unite(path);
  EXPECT_EQ(none.code, 1);
  EXPECT_TRUE(contains(none.err, "a.gpkg has 2 layers: a (polygons) and b (polygons); name one, as in")) << none.err;
  EXPECT_TRUE(contains(none.err, "--layer a")) << none.err;
  EXPECT_TRUE(contains(unite(path + ":b").out, "2 2"));
  EXPECT_TRUE(contains(unite(path, {"--layer", "b"}).out, "2 2"));
  EXPECT_FALSE(contains(unite(path + ":a", {"--layer", "b"}).out, "2 2"));
  const ProgramRun wrong = unite(path + ":c");
  EXPECT_EQ(wrong.code, 1);
  EXPECT_TRUE(contains(wrong.err, "has no layer c; it has a (polygons) and b (polygons)")) << wrong.err;
  // Rows have the attributes of the layer that is named.
  const ProgramRun rows =
      oblast_program({"overlay", "intersection", path + ":a", path + ":b", "-o", folder.path("rows.geojson"), "-q"});
  EXPECT_EQ(rows.code, 0) << rows.err;
  EXPECT_EQ(rows_of(folder.path("rows.geojson")).columns, "polygon_1: 32-bit integers, polygon_2: 32-bit integers");
}

TEST(Layers, AColonMayBePartOfTheNameOfAFile) {
  const Folder folder;
  write_file(folder / "june:2013.wkt", unit_square);
  EXPECT_EQ(unite(folder.path("june:2013.wkt")).code, 0);
  const ProgramRun wkt = unite(folder.path("june:2013.wkt:x"));
  EXPECT_EQ(wkt.code, 1);
  EXPECT_TRUE(contains(wkt.err, "no layers")) << wkt.err;
}

TEST(PassedOver, IsSaidInOneLineEachEvenWithQuiet) {
  const Folder folder;
  fs::create_directories(folder / "fires/2012");
  write_file(folder / "fires/notes.txt", "text");
  write_layer(folder / "fires/a.geojson",
              {square(0, 1, R"("name":"x","people":3)"),
               R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1,2]}})",
               R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}})"});
  const ProgramRun run = unite(folder.path("fires"), {"-q"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "fires: a file that is no vector file was not read: notes.txt\n")) << run.err;
  EXPECT_TRUE(contains(run.err, "fires: a subfolder was not read: 2012\n")) << run.err;
  EXPECT_TRUE(contains(run.err, "note: input: 1 line feature passed over\n")) << run.err;
  EXPECT_TRUE(contains(run.err, "note: input: 1 point feature passed over\n")) << run.err;
  EXPECT_TRUE(contains(run.err, "note: input: 2 attributes passed over: name and people\n")) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 5) << run.err;
}

TEST(PassedOver, TheColumnsOfALayerThatAResultOfRowsDoesNotHave) {
  const Folder folder;
  write_layer(folder / "a.geojson", {square(0, 2, R"("name":"x")")});
  write_layer(folder / "b.geojson", {square(1, 2, R"("people":3)")});
  const ProgramRun run = oblast_program(
      {"overlay", "difference", folder.path("a.geojson"), folder.path("b.geojson"), "-o", folder.path("o.gpkg"), "-q"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "note: B: 1 attribute passed over: people\n");
}

TEST(Folders, TheOutputIsNotReadOnARerun) {
  const Folder folder;
  fs::create_directory(folder / "fires");
  write_file(folder / "fires/a.wkt", unit_square);
  const std::string out = folder.path("fires/result.wkt");
  const Words call{"union", folder.path("fires"), "-o", out, "--overwrite", "--fill", "atleast:1", "-q"};
  ASSERT_EQ(oblast_program(call).code, 0);
  const std::string first = read_file(out);
  const ProgramRun again = oblast_program(call);
  EXPECT_EQ(again.code, 0);
  EXPECT_TRUE(contains(again.err, "result.wkt is the output of this call, and was not read")) << again.err;
  EXPECT_EQ(read_file(out), first);
  const ProgramRun twice =
      oblast_program({"union", folder.path("fires"), "-o", out, "--overwrite", "--fill", "atleast:2"});
  EXPECT_TRUE(contains(read_file(out), "EMPTY")) << twice.err;
}

TEST(Archives, AreReadLikeTheFileInThem) {
  const Folder folder;
  ASSERT_EQ(oblast_program({"union", "-", "-o", folder.path("fires.shp"), "-q"}, unit_square).code, 0);
  write_file(folder / "other.wkt", unit_square);
  const auto pack = [&](const std::string& archive, const std::string& files) {
    return std::system(fmt::format("cd '{}' && python3 -m zipfile -c {} {}", folder.path(""), archive, files).c_str());
  };
  ASSERT_EQ(pack("one.zip", "fires.shp fires.shx fires.dbf"), 0);
  ASSERT_EQ(pack("two.zip", "fires.shp fires.shx fires.dbf other.wkt"), 0);
  for (const std::string& input :
       {folder.path("one.zip"), "/vsizip/" + folder.path("one.zip"), "/vsizip/" + folder.path("one.zip/fires.shp"),
        folder.path("two.zip:other"), folder.path("two.zip:fires.shp")}) {
    const ProgramRun run = unite(input, {"-q"});
    EXPECT_EQ(run.code, 0) << input << ": " << run.err;
    EXPECT_TRUE(contains(run.out, "1 1")) << input;
  }
  const ProgramRun several = unite(folder.path("two.zip"));
  EXPECT_EQ(several.code, 1);
  EXPECT_TRUE(contains(several.err, "two.zip has 2 vector files: fires.shp and other.wkt; name one")) << several.err;
}

TEST(StandardInput, MayBeWktWkbOrGeojson) {
  const std::string square = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)))\n";
  for (const std::string format : {"wkt", "wkb", "geojson"}) {
    const ProgramRun there = unite("-", {"-q", "--format", format}, unit_square);
    ASSERT_EQ(there.code, 0) << there.err;
    EXPECT_EQ(unite("-", {"-q"}, there.out).out, square) << format;
    // With attributes: the data is read once.
    const ProgramRun rows = oblast_program({"dissolve", "-", "-o", "-", "-q"}, there.out);
    EXPECT_EQ(rows.out, square) << rows.err;
  }
  const std::string ewkb =
      "0103000020E61000000100000004000000000000000000000000000000000000000000000000000840000000000000000000"
      "00000000000840000000000000084000000000000000000000000000000000";
  const ProgramRun run = unite("-", {"--json", "-q"}, ewkb + "\n");
  EXPECT_EQ(run.out, "MULTIPOLYGON (((0 0, 3 0, 3 3, 0 0)))\n");
  EXPECT_EQ(Json::parse(run.err)["crs"], "WGS 84 (EPSG:4326)");
}

TEST(StandardInput, ThatIsNoneOfTheseIsAnErrorThatSaysWhy) {
  const std::pair<std::string, std::string> inputs[] = {
      {"", "standard input is empty"},
      {" \n\t\n", "standard input is empty"},
      {"SQLite format 3", "GeoPackage"},
      {std::string("\x01\x03\x00\x00\x00\x01\x00", 7), "geometry 1, byte 0: not Well-Known Binary, or cut off"},
      {"0103zz", "character 5"},
      {"{\"type\":\"Feature", "standard input"},
      {"POLYGON ((0 0, 4 0, 4 4 0 4, 0 0))",
       "line 1, column 25: a vertex has more than two numbers; is a comma missing"},
  };
  for (const auto& [input, said] : inputs) {
    const ProgramRun run = unite("-", {}, input);
    EXPECT_EQ(run.code, 1) << input;
    EXPECT_EQ(run.out, "") << input;
    EXPECT_TRUE(contains(run.err, said)) << run.err;
  }
}

TEST(CoordinateSystems, OfThreeAndTwoDimensionsAreOne) {
  const Folder folder;
  write_file(folder / "a.geojson", geojson(box(0, 0, 2, 2)));
  write_file(folder / "b.geojson", geojson("[[1,1,5],[3,1,5],[3,3,5],[1,1,5]]"));
  const std::string out = folder.path("o.gpkg");
  const ProgramRun run = oblast_program(
      {"overlay", "intersection", folder.path("a.geojson"), folder.path("b.geojson"), "-o", out, "--merge", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["crs"], "WGS 84 (EPSG:4326)");
  write_file(folder / "c.geojson", geojson("[[1,1,5],[3,1,5],[3,3,5],[1,1,5]]", 4979));
  const ProgramRun alone = unite(folder.path("c.geojson"), {"--json"});
  EXPECT_EQ(Json::parse(alone.err)["crs"], "WGS 84 (EPSG:4326)");
}

TEST(CoordinateSystems, OneOperandWithoutNeedsAnAssumption) {
  const Folder folder;
  write_file(folder / "a.geojson", geojson(box(0, 0, 2, 2), 3035));
  write_file(folder / "b.wkt", unit_square);
  for (const Words& more : {Words{"--merge"}, Words{}}) {
    Words call{"overlay",
               "intersection",
               folder.path("a.geojson"),
               folder.path("b.wkt"),
               "-o",
               folder.path(more.empty() ? "rows.gpkg" : "merged.gpkg")};
    call.insert(call.end(), more.begin(), more.end());
    const ProgramRun refused = oblast_program(call);
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(contains(refused.err, "b.wkt) names no coordinate system")) << refused.err;
    EXPECT_TRUE(contains(refused.err, "add --assume-crs EPSG:3035")) << refused.err;
    call.insert(call.end(), {"--assume-crs", "EPSG:3035", "--overwrite"});
    const ProgramRun run = oblast_program(call);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(contains(run.err, "taken to be in ETRS89-extended / LAEA Europe (EPSG:3035)")) << run.err;
  }
  const ProgramRun unknown = unite(folder.path("b.wkt"), {"--assume-crs", "EPSG:1"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(contains(unknown.err, "EPSG:1 is not a coordinate system")) << unknown.err;
}

TEST(CoordinateSystems, ATransformationIsSaid) {
  const Folder folder;
  write_file(folder / "a.geojson", geojson(box(10, 50, 11, 51)));
  const ProgramRun run = unite(folder.path("a.geojson"), {"--t_srs", "EPSG:3857", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = Json::parse(run.err);
  EXPECT_EQ(json["crs"], "WGS 84 / Pseudo-Mercator (EPSG:3857)");
  EXPECT_EQ(json["notes"][0],
            "input: transformed from WGS 84 (EPSG:4326) to WGS 84 / Pseudo-Mercator (EPSG:3857); edges stay straight");
  EXPECT_NEAR(json["result"]["area"].get<double>(), 111319.49 * 175017.88, 1e7);
  // Two systems become one.
  write_file(folder / "b.geojson", geojson(box(1113194, 6446275, 1113294, 6446375), 3857));
  const Words two{"overlay", "intersection", folder.path("a.geojson"), folder.path("b.geojson"), "-o", "-", "--merge"};
  const ProgramRun refused = oblast_program(two);
  EXPECT_EQ(refused.code, 1);
  EXPECT_TRUE(contains(refused.err, "add --t_srs EPSG:4326")) << refused.err;
  Words both = two;
  both.insert(both.end(), {"--t_srs", "EPSG:3857", "-q"});
  EXPECT_TRUE(contains(oblast_program(both).out, "6446375")) << oblast_program(both).err;
  // Without a system there is nothing to transform from.
  const ProgramRun none = unite("-", {"--t_srs", "EPSG:3857"}, unit_square);
  EXPECT_EQ(none.code, 1);
  EXPECT_TRUE(contains(none.err, "cannot be transformed")) << none.err;
  const ProgramRun pole = unite("-", {"--t_srs", "EPSG:3857"}, "SRID=4326;POLYGON ((0 0, 1 0, 1 95, 0 0))");
  EXPECT_EQ(pole.code, 1);
  EXPECT_TRUE(contains(pole.err, "vertex 2: (1, 95) cannot be transformed")) << pole.err;
}

TEST(Coordinates, ThatCannotBeMeantAreWarnedOf) {
  const auto warned = [](const std::string& wkt, const std::string& warning) {
    const ProgramRun run = unite("-", {"-q"}, wkt);
    EXPECT_EQ(run.code, 0) << run.err;
    if (warning.empty()) {
      EXPECT_EQ(run.err, "") << wkt;
    } else {
      EXPECT_TRUE(contains(run.err, "warning: input: " + warning)) << wkt << ": " << run.err;
    }
  };
  warned("SRID=4326;POLYGON ((100 80, 101 80, 101 95, 100 80))", "1 vertex with a latitude beyond 90 degrees");
  warned("SRID=4326;POLYGON ((50 100, 60 100, 60 130, 50 100))",
         "longitude and latitude look swapped in standard input");
  // The area of use of ETRS89 is Europe.
  warned("SRID=4258;POLYGON ((50 10, 51 10, 51 11, 50 10))", "longitude and latitude look swapped");
  warned("SRID=4326;POLYGON ((170 10, -170 10, -170 20, 170 20, 170 10))", "1 polygon across the date line");
  warned("SRID=4326;POLYGON ((179 10, 181 10, 181 20, 179 10))", "1 polygon across the date line");
  // The whole world, Europe, the plane, and metres are as they should be.
  warned("SRID=4326;POLYGON ((-180 -90, 180 -90, 180 90, -180 90, -180 -90))", "");
  warned("SRID=4258;POLYGON ((10 50, 11 50, 11 51, 10 50))", "");
  warned("POLYGON ((1000 1000, 2000 1000, 2000 2000, 1000 1000))", "");
  warned("SRID=3857;POLYGON ((1000 1000, 2000 1000, 2000 2000, 1000 1000))", "");
}

TEST(Coordinates, OperandsThatLieApartAreSaidWithTheirBoxes) {
  const Folder folder;
  write_file(folder / "a.geojson", geojson(box(30, 50, 31, 51)));
  write_file(folder / "b.geojson", geojson(box(50, 30, 51, 31)));
  for (const Words& more : {Words{"--merge"}, Words{}}) {
    Words call{"overlay", "intersection", folder.path("a.geojson"), folder.path("b.geojson"), "-o", "-", "-q"};
    call.insert(call.end(), more.begin(), more.end());
    const ProgramRun run = oblast_program(call);
    EXPECT_EQ(run.code, 0);
    EXPECT_TRUE(contains(run.err, "warning: A and B lie apart: A has x 30 to 31, y 50 to 51")) << run.err;
    EXPECT_TRUE(contains(run.err, "x and y of A or B look swapped")) << run.err;
  }
}

}  // namespace
}  // namespace oblast::test
