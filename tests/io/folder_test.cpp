// Many files as one operand: order, parallel reading, several layers, coordinate systems.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/crs.h"
#include "io_support.h"

namespace oblast::io {
namespace {

namespace fs = std::filesystem;

class Folder : public FolderTest {
 protected:
  WriteOptions with_crs(int epsg) const {
    WriteOptions options;
    options.crs_wkt = crs_wkt(folder_.string(), epsg);
    return options;
  }
};

TEST_F(Folder, FilesAreReadByNameWhateverTheirFormat) {
  const auto triangle_at = [](double x) { return RegionSet{{{x, 0}, {x + 1, 0}, {x, 1}}, {3}, {1}}; };
  write(path("c.shp"), triangle_at(3));
  write(path("a.gpkg"), triangle_at(1));
  write(path("d.wkt"), triangle_at(4));
  write(path("b.fgb"), triangle_at(2));
  file("readme.txt", "not data");
  file("settings.json", "{\"not\": \"vector data\"}");
  file(".hidden.wkt", "POLYGON ((7 7, 8 7, 7 8))");
  const Layer layer = read_file(folder_.string());
  ASSERT_EQ(layer.files.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(fs::path(layer.files[i]).filename().string()[0], "abcd"[i]);
    EXPECT_EQ(layer.features[i].file, i);
    EXPECT_EQ(layer.features[i].first_polygon, i);
    EXPECT_EQ(layer.regions.points[3 * i].x, static_cast<double>(i + 1));
  }
}

TEST_F(Folder, ThreadsChangeNothing) {
  RegionSet all;
  for (int i = 0; i < 60; ++i) {
    const RegionSet part = scattered(7, static_cast<unsigned>(i));
    write(path(fmt::format("pass-{}.shp", 100 + i)), part);
    const auto points = static_cast<std::uint32_t>(all.points.size());
    const auto contours = static_cast<std::uint32_t>(all.contour_ends.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const std::uint32_t end : part.contour_ends) all.contour_ends.push_back(points + end);
    for (const std::uint32_t end : part.polygon_ends) all.polygon_ends.push_back(contours + end);
  }
  for (const int threads : {1, 2, 8}) {
    std::vector<double> shares;
    ReadOptions options;
    options.threads = threads;
    options.progress = [&](double share) { shares.push_back(share); };
    const Layer layer = read_file(folder_.string(), options);
    EXPECT_TRUE(same_bits(layer.regions, all));
    EXPECT_EQ(layer.report.features, 420U);
    EXPECT_EQ(shares.size(), 60U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_NEAR(shares.back(), 1, 1e-12);
  }
}

TEST_F(Folder, TheFirstFaultyFileByNameIsReported) {
  for (int i = 10; i < 40; ++i) file(fmt::format("p{}.wkt", i), i < 15 ? "POLYGON ((0 0, 1 0, 0 1))" : "BROKEN");
  ReadOptions options;
  options.threads = 4;
  for (int repeat = 0; repeat < 5; ++repeat) {
    EXPECT_TRUE(mentions(read_error(folder_.string(), options), {"p15.wkt, line 1"}));
  }
}

TEST_F(Folder, TwoCoordinateSystemsNameBothFiles) {
  write(path("b.shp"), one_triangle(), with_crs(4326));
  write(path("c.gpkg"), one_triangle(), with_crs(3035));
  EXPECT_TRUE(
      mentions(read_error(folder_.string()), {"two coordinate systems", "b.shp", "EPSG:4326", "c.gpkg", "EPSG:3035"}));
}

TEST_F(Folder, FilesWithoutACoordinateSystemNeedAnAssumption) {
  write(path("a.shp"), one_triangle());
  write(path("b.shp"), one_triangle(), with_crs(32633));
  write(path("c.wkt"), one_triangle());
  EXPECT_TRUE(mentions(read_error(folder_.string()), {"a.shp", "b.shp", "EPSG:32633", "--assume-crs"}));
  ReadOptions options;
  options.assume_crs = crs_from_text("EPSG:32633");
  const Layer layer = read_file(folder_.string(), options);
  EXPECT_TRUE(mentions(crs_name(layer.crs_wkt), {"EPSG:32633"}));
  ASSERT_EQ(layer.notes.size(), 1U);
  EXPECT_TRUE(mentions(layer.notes.front(), {"taken to be in", "EPSG:32633"}));
}

TEST_F(Folder, WhatIsPassedOverIsSaid) {
  write(path("a.shp"), one_triangle());
  fs::create_directory(path("older"));
  fs::create_directory(path("oldest"));
  file("readme.txt", "not data");
  file("table.csv", "name,people\nx,3\n");
  const std::string output = path("result.gpkg");
  write(output, one_triangle());
  ReadOptions options;
  options.output = output;
  const Layer layer = read_file(folder_.string(), options);
  EXPECT_EQ(layer.files, std::vector<std::string>{path("a.shp")});
  ASSERT_EQ(layer.notes.size(), 3U);
  EXPECT_TRUE(mentions(layer.notes[0], {"result.gpkg", "output"}));
  EXPECT_TRUE(mentions(layer.notes[1], {"2 files", "readme.txt and table.csv"}));
  EXPECT_TRUE(mentions(layer.notes[2], {"2 subfolders", "older and oldest"}));
}

TEST_F(Folder, TheSameSystemInEveryFormatIsOne) {
  for (const int epsg : {4326, 3035, 32633}) {
    const std::string sub = std::to_string(epsg);
    fs::create_directory(path(sub));
    for (const char* name : {"/a.shp", "/b.gpkg", "/c.geojson", "/d.fgb"})
      write(path(fmt::format("{}{}", epsg, name)), one_triangle(), with_crs(epsg));
    EXPECT_TRUE(mentions(crs_name(read_file(path(sub)).crs_wkt), {fmt::format("EPSG:{}", epsg)}));
  }
}

TEST_F(Folder, SeveralLayersOfOneFile) {
  const auto placemark = [](const char* x) {
    return fmt::format(
        "<Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>{0},0 {0},1 {0}5,1 {0},0</coordinates>"
        "</LinearRing></outerBoundaryIs></Polygon></Placemark>",
        x);
  };
  file("a.kml",
       fmt::format("<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>"
                   "<Folder><name>first</name>{}</Folder><Folder><name>second</name>{}</Folder></Document></kml>",
                   placemark("1"), placemark("2")));
  EXPECT_TRUE(mentions(read_error(path("a.kml")), {"a.kml has 2 layers: first", "second", "a.kml:first", "--layer"}));
  EXPECT_TRUE(mentions(read_error(path("a.kml:third")), {"no layer third", "first", "second"}));
  const Layer layer = read_file(path("a.kml:second"));
  EXPECT_EQ(layer.regions.points, (std::vector<Point>{{2, 0}, {2, 1}, {25, 1}}));
  EXPECT_EQ(layer.files, std::vector<std::string>{path("a.kml:second")});
  ReadOptions options;
  options.layer = "first";
  EXPECT_EQ(read_file(path("a.kml"), options).regions.points, (std::vector<Point>{{1, 0}, {1, 1}, {15, 1}}));
}

TEST(SameCrs, AxisOrderAndMissingOnesDoNotMatter) {
  const std::string crs84 =
      R"wkt(GEOGCRS["WGS 84 (CRS84)",DATUM["World Geodetic System 1984",ELLIPSOID["WGS 84",6378137,298.257223563,)wkt"
      R"wkt(LENGTHUNIT["metre",1]]],PRIMEM["Greenwich",0,ANGLEUNIT["degree",0.0174532925199433]],CS[ellipsoidal,2],)wkt"
      R"wkt(AXIS["geodetic longitude (Lon)",east,ORDER[1],ANGLEUNIT["degree",0.0174532925199433]],)wkt"
      R"wkt(AXIS["geodetic latitude (Lat)",north,ORDER[2],ANGLEUNIT["degree",0.0174532925199433]],ID["OGC","CRS84"]])wkt";
  const std::string folder = ::testing::TempDir();
  const std::string wgs84 = crs_wkt(folder, 4326), etrs = crs_wkt(folder, 3035);
  EXPECT_TRUE(same_crs(wgs84, wgs84));
  EXPECT_TRUE(same_crs(wgs84, crs84));
  EXPECT_TRUE(same_crs(crs84, wgs84));
  EXPECT_TRUE(same_crs("", wgs84));
  EXPECT_TRUE(same_crs(wgs84, ""));
  EXPECT_TRUE(same_crs("", ""));
  EXPECT_TRUE(same_crs(wgs84, crs_from_text("EPSG:4979")));      // with height
  EXPECT_TRUE(same_crs(crs_from_text("EPSG:3035+5621"), etrs));  // with height above the sea
  EXPECT_EQ(crs_name(crs_from_text("EPSG:4979")), "WGS 84 (EPSG:4326)");
  EXPECT_FALSE(same_crs(wgs84, etrs));
  EXPECT_FALSE(same_crs(wgs84, crs_wkt(folder, 4284)));  // Pulkovo 1942: degrees too, another datum
  EXPECT_FALSE(same_crs(crs_wkt(folder, 32633), crs_wkt(folder, 32634)));
  EXPECT_EQ(crs_name(""), "none");
}

}  // namespace
}  // namespace oblast::io
