// A written file reads back with the same polygons in the same order and the same bits, in every format.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "io/crs.h"
#include "io_support.h"

namespace oblast::io {
namespace {

class RoundTrip : public FolderTest, public ::testing::WithParamInterface<const char*> {
 protected:
  std::string out() const { return path(std::string("out") + GetParam()); }
  bool keeps_crs() const { return std::string(GetParam()) != ".wkt"; }
  RegionSet there_and_back(const RegionSet& regions) const {
    write(out(), regions);
    return read_file(out()).regions;
  }
};

TEST_P(RoundTrip, HolesAndSeveralPolygons) {
  EXPECT_TRUE(same_bits(square_with_hole(), there_and_back(square_with_hole())));
}

TEST_P(RoundTrip, CoordinatesThatUseAllBits) {
  const RegionSet regions = scattered(500, 7);
  EXPECT_TRUE(same_bits(regions, there_and_back(regions)));
}

TEST_P(RoundTrip, ExtremeCoordinates) {
  const double next = std::nextafter(1.0, 2.0);
  const RegionSet regions{{{0.1, 1.0 / 3},
                           {next, 1e22},
                           {-1e-17, 123456789.123456789},
                           {5e-91, 0},
                           {9007199254740993.0, 1},
                           {-2e90, -2e90},
                           {1e90, -7}},
                          {3, 7},
                          {1, 2}};
  EXPECT_TRUE(same_bits(regions, there_and_back(regions)));
}

TEST_P(RoundTrip, NothingAtAll) {
  const Layer layer = [&] {
    write(out(), RegionSet{});
    return read_file(out());
  }();
  EXPECT_TRUE(layer.regions.empty());
  EXPECT_TRUE(layer.features.empty());
}

TEST_P(RoundTrip, OneFeatureAPolygon) {
  write(out(), scattered(20, 3));
  const Layer layer = read_file(out());
  const bool one_geometry = std::string(GetParam()) == ".wkt";  // a single MULTIPOLYGON
  EXPECT_EQ(layer.features.size(), one_geometry ? 1U : 20U);
  EXPECT_EQ(layer.report.features, layer.features.size());
  EXPECT_EQ(layer.report.unclosed_contours, 0U);
}

TEST_P(RoundTrip, CoordinateSystemIsKept) {
  for (const int epsg : {4326, 3035, 32633}) {
    WriteOptions options;
    options.existing = Existing::overwrite;
    options.crs_wkt = crs_wkt(folder_.string(), epsg);
    ASSERT_TRUE(mentions(crs_name(options.crs_wkt), {fmt::format("EPSG:{}", epsg)}));
    write(out(), one_triangle(), options);
    const Layer layer = read_file(out());
    EXPECT_TRUE(same_bits(one_triangle(), layer.regions));
    if (keeps_crs()) {
      EXPECT_EQ(crs_name(layer.crs_wkt), crs_name(options.crs_wkt));
      EXPECT_TRUE(same_crs(layer.crs_wkt, options.crs_wkt));
    }
  }
}

TEST_P(RoundTrip, NoCoordinateSystemStaysNone) {
  if (std::string(GetParam()).ends_with("json")) GTEST_SKIP() << "GeoJSON without one is WGS 84 by its definition";
  write(out(), one_triangle());
  EXPECT_EQ(read_file(out()).crs_wkt, "");
}

TEST_P(RoundTrip, SecondWritingGivesTheSamePolygons) {
  write(out(), scattered(40, 5));
  const Layer first = read_file(out());
  WriteOptions options;
  options.existing = Existing::overwrite;
  write(out(), first.regions, options);
  EXPECT_TRUE(same_bits(first.regions, read_file(out()).regions));
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, ::testing::Values(".shp", ".gpkg", ".geojson", ".fgb", ".wkt", ".json"),
                         [](const auto& suite) { return std::string(suite.param).substr(1); });

using WrittenFiles = FolderTest;

TEST_F(WrittenFiles, ShapefileIsDirectedAsEsriWants) {
  write(path("a.shp"), square_with_hole());
  const std::string bytes = contents("a.shp");
  // First record: header 100, record header 8, shape type 4, box 32, counts 8, two part starts 8.
  const auto number = [&](std::size_t i) {
    double value = 0;
    bytes.copy(reinterpret_cast<char*>(&value), sizeof value, 100 + 8 + 4 + 32 + 8 + 8 + 8 * i);
    return value;
  };
  // Outer 0 0, 0 8, 8 8, 8 0, 0 0: clockwise and closed; then the hole 2 2, 6 2, ...: anticlockwise.
  const std::vector<double> expected = {0, 0, 0, 8, 8, 8, 8, 0, 0, 0, 2, 2, 6, 2, 6, 6, 2, 6, 2, 2};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(number(i), expected[i]) << i;
}

TEST_F(WrittenFiles, GeoJsonIsShortAndClosed) {
  write(path("a.geojson"), RegionSet{{{0.1, 0}, {1, 0}, {1, 1.5}}, {3}, {1}});
  EXPECT_TRUE(mentions(contents("a.geojson"), {R"("polygon":0)", "[[[0.1,0],[1,0],[1,1.5],[0.1,0]]]"}));
}

TEST_F(WrittenFiles, GeoJsonNeedsACodeForItsCoordinateSystem) {
  WriteOptions options;
  options.crs_wkt = R"(PROJCS["Home",GEOGCS["Bessel","DATUM"],PROJECTION["Albers"]])";  // not a valid coordinate system
  EXPECT_NE(write_error(path("a.geojson"), one_triangle(), options), "");
  EXPECT_FALSE(exists("a.geojson"));
}

TEST_F(WrittenFiles, DegenerateContoursAreWrittenAsTheyAre) {
  const RegionSet regions{{{1, 1}, {2, 2}, {3, 1}, {4, 4}, {5, 5}}, {1, 3, 5}, {1, 2, 3}};
  for (const char* name : {"a.shp", "a.gpkg", "a.fgb", "a.geojson", "a.wkt"}) {
    write(path(name), regions);
    EXPECT_TRUE(same_bits(regions, read_file(path(name)).regions)) << name;
  }
}

}  // namespace
}  // namespace oblast::io
