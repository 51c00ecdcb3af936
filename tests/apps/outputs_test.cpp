// Where results go: standard output in three formats, layers of a GeoPackage, and every format that GDAL writes here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/program_run.h"
#include "apps/rows_support.h"

namespace oblast::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* unit_square = "SRID=4326;POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))";
constexpr const char* large_square = "SRID=4326;POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))";

ProgramRun unite(const std::string& wkt, const std::string& out, Words more = {}) {
  Words words{"union", "-", "-o", out, "-q"};
  words.insert(words.end(), more.begin(), more.end());
  return oblast_program(words, wkt);
}

std::string wkt_of(const std::string& input) { return oblast_program({"union", input, "-o", "-", "-q"}).out; }

constexpr const char* unit_text = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)))\n";
constexpr const char* large_text = "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)))\n";

TEST(StandardOutput, HasTheFormatThatIsWanted) {
  EXPECT_EQ(unite(unit_square, "-", {"--format", "wkt"}).out, unit_text);
  const Json geojson = Json::parse(unite(unit_square, "-", {"--format", "geojson"}).out);
  EXPECT_EQ(geojson["features"][0]["geometry"]["type"], "Polygon");
  const std::string wkb = unite(unit_square, "-", {"--format", "wkb"}).out;
  EXPECT_EQ(wkb.substr(0, 9), std::string("\x01\x03\x00\x00\x00\x01\x00\x00\x00", 9));
  EXPECT_EQ(wkb.size(), 9U + 4 + 5 * 16);
  EXPECT_EQ(unite(unit_square, "-", {"--format", "svg"}).code, 2);
}

TEST(StandardOutput, OfRowsHasTheirAttributesIfItsFormatCan) {
  const Folder folder;
  write_layer(folder / "a.geojson", {square(0, 1, R"("name":"x")"), square(5, 1, R"("name":"y")")});
  const auto dissolved = [&](const std::string& format) {
    return oblast_program({"dissolve", folder.path("a.geojson"), "--by", "name", "-o", "-", "-q", "--format", format});
  };
  EXPECT_EQ(Json::parse(dissolved("geojson").out)["features"][1]["properties"]["name"], "y");
  const ProgramRun wkb = dissolved("wkb");
  EXPECT_TRUE(contains(wkb.err, "WKB has no attributes; 1 column is left out")) << wkb.err;
  EXPECT_EQ(oblast_program({"dissolve", "-", "-o", "-", "-q"}, wkb.out).out,
            "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((5 0, 6 0, 6 1, 5 1, 5 0)))\n");
}

TEST(StandardOutput, LeavesJsonToStandardError) {
  const ProgramRun run = unite(unit_square, "-", {"--json"});
  EXPECT_EQ(run.out, unit_text);
  EXPECT_EQ(Json::parse(run.err)["result"]["area"], 1.0);
  const ProgramRun failed = unite("POLYGON ((0 0", "-", {"--json"});
  EXPECT_EQ(failed.code, 1);
  EXPECT_EQ(failed.out, "");
  EXPECT_EQ(Json::parse(failed.err)["exit_code"], 1);
  for (const char* command : {"hull", "triangulate"}) {
    const ProgramRun other = oblast_program({command, "-", "-o", "-", "--json"}, unit_square);
    EXPECT_EQ(Json::parse(other.err)["output"], "-") << command;
    EXPECT_TRUE(contains(other.out, "POLYGON")) << command;
  }
}

TEST(GeopackageLayers, AreAddedAndReplacedWithoutTheOthers) {
  const Folder folder;
  const std::string path = folder.path("a.gpkg");
  ASSERT_EQ(unite(unit_square, path).code, 0);
  ASSERT_EQ(unite(large_square, path + ":large").code, 0);  // no --overwrite: nothing is replaced
  EXPECT_EQ(wkt_of(path + ":a"), unit_text);
  EXPECT_EQ(wkt_of(path + ":large"), large_text);

  const std::string before = read_file(path);
  const ProgramRun refused = unite(unit_square, path + ":large");
  EXPECT_EQ(refused.code, 1);
  EXPECT_TRUE(contains(refused.err, "has a layer large already (--overwrite replaces it)")) << refused.err;
  EXPECT_TRUE(read_file(path) == before);

  EXPECT_EQ(unite(unit_square, path + ":large", {"--overwrite"}).code, 0);
  EXPECT_EQ(wkt_of(path + ":large"), unit_text);
  EXPECT_EQ(wkt_of(path + ":a"), unit_text);

  // A file without a layer: the layer with its name.
  EXPECT_EQ(unite(large_square, path).code, 1);
  const ProgramRun kept = unite(large_square, path, {"--overwrite"});
  EXPECT_EQ(kept.code, 0);
  EXPECT_TRUE(contains(kept.err, "a.gpkg keeps what it had besides the layer a: large")) << kept.err;
  EXPECT_EQ(wkt_of(path + ":a"), large_text);
  EXPECT_EQ(wkt_of(path + ":large"), unit_text);
  EXPECT_EQ(folder.names(), Words{"a.gpkg"});
}

TEST(GeopackageLayers, RowsAreAddedToo) {
  const Folder folder;
  const std::string path = folder.path("a.gpkg");
  write_layer(folder / "in.geojson", {square(0, 1, R"("name":"x")"), square(5, 1, R"("name":"y")")});
  ASSERT_EQ(unite(unit_square, path).code, 0);
  const ProgramRun run =
      oblast_program({"dissolve", folder.path("in.geojson"), "--by", "name", "-o", path + ":by name", "-q"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(rows_of(path + ":by name").rows, (Lines{"name=x area=1", "name=y area=1"}));
  EXPECT_EQ(wkt_of(path + ":a"), unit_text);
}

TEST(GeopackageLayers, CannotGoIntoWhatHoldsNone) {
  const Folder folder;
  write_file(folder / "text.gpkg", "no GeoPackage");
  const ProgramRun text = unite(unit_square, folder.path("text.gpkg:x"));
  EXPECT_EQ(text.code, 1);
  EXPECT_TRUE(contains(text.err, "no GeoPackage that can be read")) << text.err;
  const ProgramRun other = unite(unit_square, folder.path("a.fgb:x"));
  EXPECT_EQ(other.code, 1);
  EXPECT_TRUE(contains(other.err, "only .gpkg files have several layers; leave out :x")) << other.err;
  // Changes that another program has not yet put into the file would be lost.
  ASSERT_EQ(unite(unit_square, folder.path("open.gpkg")).code, 0);
  write_file(folder / "open.gpkg-wal", "changes");
  const std::string before = read_file(folder / "open.gpkg");
  const ProgramRun open = unite(unit_square, folder.path("open.gpkg:x"));
  EXPECT_EQ(open.code, 1);
  EXPECT_TRUE(contains(open.err, "open.gpkg-wal has changes that are not in it yet")) << open.err;
  EXPECT_TRUE(read_file(folder / "open.gpkg") == before);
}

TEST(Geopackage, HasTheSameBytesOnEveryRun) {
  const Folder folder;
  write_layer(folder / "in.geojson", {square(0, 1, R"("name":"x")")});
  const auto run = [&](const std::string& name) {
    fs::create_directory(folder / name);
    EXPECT_EQ(unite(unit_square, folder.path(name + "/a.gpkg")).code, 0);
    EXPECT_EQ(unite(large_square, folder.path(name + "/a.gpkg:b")).code, 0);
    EXPECT_EQ(
        oblast_program({"dissolve", folder.path("in.geojson"), "-o", folder.path(name + "/rows.gpkg"), "-q"}).code, 0);
  };
  run("first");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // a timestamp would differ
  run("second");
  for (const char* file : {"/a.gpkg", "/rows.gpkg"})
    EXPECT_TRUE(read_file(folder / ("first" + std::string(file))) == read_file(folder / ("second" + std::string(file))))
        << file;
}

TEST(Formats, EachReadsBackWhatWasWritten) {
  const std::string thirds = "SRID=4326;POLYGON ((0.1 0.30000000000000004, 1 0, 1 1, 0.1 0.30000000000000004))";
  const std::string exact = "MULTIPOLYGON (((0.1 0.30000000000000004, 1 0, 1 1, 0.1 0.30000000000000004)))\n";
  const std::string rounded = "MULTIPOLYGON (((0.1 0.3, 1 0, 1 1, 0.1 0.3)))\n";
  for (const std::string extension : {"shp", "gpkg", "geojson", "fgb", "csv", "wkb", "wkt", "kml", "gml"}) {
    const Folder folder;
    const std::string path = folder.path("o." + extension);
    const ProgramRun run = unite(thirds, path);
    ASSERT_EQ(run.code, 0) << run.err;
    const bool rounds = extension == "kml" || extension == "gml";
    EXPECT_EQ(wkt_of(path), rounds ? rounded : exact) << extension;
    EXPECT_EQ(contains(run.err, "rounded vertices: 1 of 3"), rounds) << run.err;
    EXPECT_EQ(unite(thirds, path).code, 1);
    EXPECT_EQ(unite(thirds, path, {"--overwrite"}).code, 0);
    EXPECT_EQ(wkt_of(path), rounds ? rounded : exact) << extension;
  }
}

TEST(Formats, TablesKeepAttributes) {
  const Folder folder;
  write_file(folder / "in.geojson",
             R"({"type":"FeatureCollection","features":[)" +
                 square(0, 1, R"("name":"a, \"b\"","code":"007","people":9007199254740993,"part":0.1)") + "," +
                 square(5, 1, R"("name":null,"code":"x","people":null,"part":2.5)") + "]}");
  const Lines rows = {"code=007 name=a, \"b\" people=9007199254740993 part=0.1 area=1",
                      "code=x name=null people=null part=2.5 area=1"};
  for (const std::string extension : {"csv", "gml", "gpkg", "geojson", "fgb"}) {
    const std::string path = folder.path("o." + extension);
    const ProgramRun run = oblast_program({"dissolve", folder.path("in.geojson"), "--by", "code", "-o", path, "-q"});
    ASSERT_EQ(run.code, 0) << run.err;
    RowsOfFile read = rows_of(path);
    for (std::string& row : read.rows) {
      if (row.starts_with("gml_id=")) row = row.substr(row.find("code="));
    }
    std::sort(read.rows.begin(), read.rows.end());  // FlatGeobuf sorts by place
    EXPECT_EQ(read.rows, rows) << extension;
    EXPECT_TRUE(contains(read.columns, "code: text, name: text, people: 64-bit integers, part: numbers")) << extension;
  }
}

TEST(Formats, CsvSaysThatItHasNoEmptyTexts) {
  const Folder folder;
  write_layer(folder / "in.geojson", {square(0, 1, R"("id":1,"name":"")")});
  const ProgramRun run = oblast_program({"dissolve", folder.path("in.geojson"), "-o", folder.path("o.csv"), "-q"});
  EXPECT_TRUE(contains(run.err, "note: empty texts: 1, which CSV does not tell from nulls")) << run.err;
  EXPECT_EQ(rows_of(folder.path("o.csv")).rows, (Lines{"id=1 name=null area=1"}));
}

TEST(Formats, KmlHasFewTypes) {
  const Folder folder;
  write_file(folder / "in.geojson", R"({"type":"FeatureCollection","features":[)" +
                                        square(0, 1, R"("people":9007199254740993,"open":true)") + "]}");
  const ProgramRun run = oblast_program({"dissolve", folder.path("in.geojson"), "-o", folder.path("o.kml"), "-q"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "people is written as text (KML has no 64-bit integers)")) << run.err;
  EXPECT_TRUE(contains(run.err, "open is written as 32-bit integers (KML has no subtype boolean)")) << run.err;
  EXPECT_TRUE(contains(rows_of(folder.path("o.kml")).rows.front(), "people=9007199254740993 open=1 "));
}

TEST(Formats, KmlIsInLongitudeAndLatitude) {
  const Folder folder;
  const ProgramRun run = unite(
      "SRID=3035;POLYGON ((4321000 3210000, 4322000 3210000, 4322000 3211000, 4321000 3210000))", folder.path("o.kml"));
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.err, "KML is always in WGS 84 (EPSG:4326)")) << run.err;
  EXPECT_TRUE(contains(run.err, "--t_srs EPSG:4326")) << run.err;
  EXPECT_TRUE(folder.names().empty());
}

TEST(Formats, WhatThisGdalCannotDoIsSaid) {
  const Folder folder;
  const ProgramRun parquet = unite(unit_square, folder.path("o.parquet"));
  if (parquet.code == 0) GTEST_SKIP() << "this GDAL writes Parquet";
  EXPECT_EQ(parquet.code, 1);
  EXPECT_TRUE(contains(parquet.err, "this build of GDAL has no driver Parquet; write .gpkg or .fgb instead"))
      << parquet.err;
  write_file(folder / "in.parquet", "PAR1");
  const ProgramRun read = oblast_program({"union", folder.path("in.parquet"), "-o", "-"});
  EXPECT_EQ(read.code, 1);
  EXPECT_TRUE(contains(read.err, "this build of GDAL has no driver Parquet; convert it to .gpkg first")) << read.err;
}

}  // namespace
}  // namespace oblast::test
