// Input that is not a polygon layer, or a broken one: a message with the place, and no output on standard error.
#include <filesystem>

#include "io_support.h"

namespace oblast::io {
namespace {

namespace fs = std::filesystem;

using BadInput = FolderTest;

std::string feature_collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string feature(const std::string& geometry) {
  return R"({"type":"Feature","properties":{},"geometry":)" + geometry + "}";
}

TEST_F(BadInput, MissingFilesAndFolders) {
  EXPECT_TRUE(mentions(read_error(path("none.shp")), {"no such file", "none.shp"}));
  fs::create_directory(path("empty"));
  EXPECT_TRUE(mentions(read_error(path("empty")), {"no vector files", "empty", ".shp", ".gpkg"}));
  EXPECT_THROW(read({}), IoError);
  const std::string twice[] = {"-", "-"};
  EXPECT_THROW(read(twice), IoError);
}

TEST_F(BadInput, FilesThatAreNoVectorData) {
  for (const char* name : {"a.gpkg", "a.fgb", "a.geojson", "a.topojson", "a.png", "a.shp", "a.wkt", "noextension"}) {
    file(name, "hello, this is text\n");
    const std::string error = read_error(path(name));
    EXPECT_TRUE(mentions(error, {name})) << name << ": " << error;
  }
  file("b.geojson", R"({"type":"something else"})");
  EXPECT_TRUE(mentions(read_error(path("b.geojson")), {"b.geojson", "not a vector file"}));
}

TEST_F(BadInput, TruncatedFiles) {
  for (const char* name : {"a.gpkg", "a.fgb", "a.geojson", "a.wkt"}) {
    write(path(name), scattered(3000, 2));
    const std::size_t size = fs::file_size(path(name));
    for (const std::size_t kept : {size - 10, size / 2, size / 10, size / 100}) {
      truncate(name, kept);
      EXPECT_TRUE(mentions(read_error(path(name)), {name})) << name << " cut to " << kept << " of " << size;
    }
  }
}

TEST_F(BadInput, GdalKeepsSilent) {
  file("a.geojson", "{\"type\":");
  write(path("b.fgb"), scattered(3000, 2));
  truncate("b.fgb", 50000);
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  EXPECT_NE(read_error(path("a.geojson")), "");
  EXPECT_NE(read_error(path("b.fgb")), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST_F(BadInput, CoordinatesThatAreNoNumbers) {
  const std::string good = feature(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]})");
  const auto bad = [](const std::string& number) {
    return feature(R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1],[0,0]]],)"
                   R"([[[0,0],[9,0],[9,9],[0,0]],[[5,1],[6,)" +
                   number + R"(],[6,2],[5,1]]]]})");
  };
  file("a.geojson", feature_collection(good + "," + bad("NaN")));
  EXPECT_TRUE(
      mentions(read_error(path("a.geojson")), {"a.geojson, feature 1, part 2, ring 2, vertex 1", "y is not a number"}));
  file("a.geojson", feature_collection(good + "," + bad("1e999")));
  EXPECT_TRUE(mentions(read_error(path("a.geojson")), {"feature 1, part 2, ring 2, vertex 1", "y is infinite"}));
  file("a.geojson", feature_collection(good + "," + bad("1e100")));
  EXPECT_TRUE(mentions(read_error(path("a.geojson")), {"vertex 1", "y is 1e+100", "domain"}));
}

TEST_F(BadInput, CurvesAndSurfacesAreRefusedWithFileFeatureAndType) {
  const auto csv = [&](const std::string& wkt) {
    return read_error(file("a.csv", "id,WKT\n1,\"POLYGON ((0 0,1 0,0 1,0 0))\"\n2,\"" + wkt + "\"\n"));
  };
  for (const char* type :
       {"CURVEPOLYGON (CIRCULARSTRING (0 0,1 1,2 0,1 -1,0 0))", "MULTISURFACE (((0 0,1 0,0 1,0 0)))",
        "COMPOUNDCURVE (CIRCULARSTRING (0 0,1 1,2 0),(2 0,0 0))", "CIRCULARSTRING (0 0,1 1,2 0)",
        "MULTICURVE ((0 0,1 1))", "GEOMETRYCOLLECTION (CURVEPOLYGON (CIRCULARSTRING (0 0,1 1,2 0,1 -1,0 0)))",
        "TIN Z (((0 0 0,1 0 0,0 1 0,0 0 0)))", "POLYHEDRALSURFACE Z (((0 0 0,1 0 0,0 1 0,0 0 0)))",
        "TRIANGLE ((0 0,1 0,0 1,0 0))"}) {
    std::string name(type);
    name = name.substr(0, name.find(' '));
    if (name == "GEOMETRYCOLLECTION") name = "CURVEPOLYGON";
    const std::string error = csv(type);
    EXPECT_TRUE(mentions(error, {"a.csv, feature 2", name})) << type << ": " << error;
  }
}

TEST_F(BadInput, OddButHarmlessIsCounted) {
  file("a.csv",
       "id,WKT\n1,\"POLYGON Z ((0 0 1,1 0 1,1 1 1))\"\n2,\"POLYGON ZM ((0 0 1 2,1 0 1 2,1 1 1 2,0 0 1 2))\"\n"
       "3,\"POLYGON M ((0 0 1,1 0 1,1 1 1))\"\n4,\"POLYGON EMPTY\"\n5,\n6,\"LINESTRING (0 0,1 1)\"\n7,\"POINT (0 0)\"\n"
       "8,\"GEOMETRYCOLLECTION (POINT (0 0),POLYGON ((0 0,1 0,1 1,1 1,0 0)))\"\n");
  const Layer layer = read_file(path("a.csv"));
  EXPECT_EQ(layer.report.features, 8U);
  EXPECT_EQ(layer.report.with_z, 2U);
  EXPECT_EQ(layer.report.with_m, 2U);
  EXPECT_EQ(layer.report.empty_geometries, 1U);
  EXPECT_EQ(layer.report.null_geometries, 1U);
  EXPECT_EQ(layer.report.lines, 1U);
  EXPECT_EQ(layer.report.points, 2U);
  EXPECT_EQ(layer.report.unclosed_contours, 2U);
  EXPECT_EQ(layer.report.repeated_vertices, 1U);
  EXPECT_EQ(layer.features.size(), 4U);
  EXPECT_EQ(layer.features.back().feature, 8);
}

TEST_F(BadInput, LinesAndPointsAreRefusedWhenToldSo) {
  ReadOptions strict;
  strict.other = OtherGeometry::refuse;
  const std::string good = feature(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]})");
  file("a.geojson", feature_collection(good + "," + feature(R"({"type":"Point","coordinates":[0,0]})")));
  EXPECT_TRUE(mentions(read_error(path("a.geojson"), strict), {"a.geojson, feature 1", "POINT"}));
  EXPECT_EQ(read_error(path("a.geojson")), "");
}

TEST_F(BadInput, TopoJsonIsRead) {
  file("a.topojson", R"({"type":"Topology","transform":{"scale":[0.5,0.5],"translate":[10,20]},"objects":{"a":)"
                     R"({"type":"GeometryCollection","geometries":[{"type":"Polygon","arcs":[[0]]}]}},)"
                     R"("arcs":[[[0,0],[2,0],[0,2],[-2,0],[0,-2]]]})");
  EXPECT_EQ(read_file(path("a.topojson")).regions.points, (std::vector<Point>{{10, 20}, {11, 20}, {11, 21}, {10, 21}}));
}

}  // namespace
}  // namespace oblast::io
