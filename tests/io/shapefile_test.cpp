// Shapefiles: the set of files and its faults, records of several rings, Z.
#include <cstring>
#include <filesystem>
#include <limits>

#include "io_support.h"

namespace oblast::io {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(double value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

class Shapefile : public FolderTest {
 protected:
  Shapefile() { write(path("a.shp"), scattered(30, 1)); }
  std::string error() const { return read_error(path("a.shp")); }
  std::size_t size(const char* name) const { return fs::file_size(folder_ / name); }
};

TEST_F(Shapefile, TruncatedShapesAreNoticed) {
  truncate("a.shp", size("a.shp") - 1);
  EXPECT_TRUE(mentions(error(), {"a.shp", "truncated", "bytes"}));
  truncate("a.shp", 60);
  EXPECT_TRUE(mentions(error(), {"a.shp", "truncated"}));
  truncate("a.shp", 0);
  EXPECT_TRUE(mentions(error(), {"a.shp", "truncated"}));
}

TEST_F(Shapefile, TruncationThatTheHeaderHidesNamesTheFeature) {
  const std::size_t cut = size("a.shp") - 20;
  truncate("a.shp", cut);
  const auto words = static_cast<unsigned>(cut / 2);
  patch("a.shp", 24, {'\0', '\0', static_cast<char>(words >> 8), static_cast<char>(words)});
  EXPECT_TRUE(mentions(error(), {"a.shp", "feature 29"}));
}

TEST_F(Shapefile, MissingIndexIsAnError) {
  fs::remove(path("a.shx"));
  EXPECT_TRUE(mentions(error(), {"a.shp", ".shx"}));
  EXPECT_FALSE(exists("a.shx")) << "nothing is rebuilt behind the user's back";
}

TEST_F(Shapefile, TruncatedIndexIsAnError) {
  truncate("a.shx", size("a.shx") - 4);
  EXPECT_TRUE(mentions(error(), {"a.shx", "truncated"}));
}

TEST_F(Shapefile, TableOfAnotherFileIsAnError) {
  truncate("a.dbf", size("a.dbf") - 30);
  EXPECT_TRUE(mentions(error(), {"a.dbf", "truncated"}));
  write(path("b.shp"), scattered(29, 1));
  fs::copy_file(path("b.dbf"), path("a.dbf"), fs::copy_options::overwrite_existing);
  EXPECT_TRUE(mentions(error(), {"a.dbf", "29", "30"}));
  fs::remove(path("a.dbf"));
  EXPECT_EQ(read_file(path("a.shp")).report.features, 30U) << "without a table there are still shapes";
}

TEST_F(Shapefile, RecordsDeletedInTheTableAreLeftOut) {
  const std::string table = contents("a.dbf");
  const auto header_bytes = static_cast<unsigned char>(table[8]), record_bytes = static_cast<unsigned char>(table[10]);
  patch("a.dbf", header_bytes + 4U * record_bytes, "*");
  EXPECT_EQ(read_file(path("a.shp")).report.features, 29U);
}

TEST_F(Shapefile, OtherContentsAreRefused) {
  file("a.shp", std::string(200, 'x'));
  EXPECT_TRUE(mentions(error(), {"a.shp", "not a shapefile"}));
}

TEST_F(Shapefile, FolderWithAShapefileThatLostItsShapes) {
  write(path("b.shp"), one_triangle());
  fs::remove(path("b.shp"));
  EXPECT_TRUE(mentions(read_error(folder_.string()), {"b.shx", "no .shp"}));
}

TEST_F(Shapefile, UnreadableCoordinateSystemIsAnError) {
  file("a.prj", "GARBAGE[\"x\"]");
  EXPECT_TRUE(mentions(error(), {"a.prj", "coordinate system"}));
  file("a.prj", "\n");
  EXPECT_EQ(read_file(path("a.shp")).crs_wkt, "");
}

TEST_F(Shapefile, BadCoordinateNamesFeatureAndVertex) {
  write(path("t.shp"), RegionSet{{{0, 0}, {4, 0}, {0, 3}, {0, 0}, {4, 0}, {0, 3}}, {3, 6}, {1, 2}});
  const std::size_t record = 8 + 4 + 32 + 8 + 4 + 4 * 16;
  const std::size_t second_points = 100 + record + (record - 4 * 16);
  patch("t.shp", second_points + 16 * 2 + 8, bytes_of(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(mentions(read_error(path("t.shp")), {"t.shp, feature 1, part 1, ring 1, vertex 2", "y is not a number"}));
  patch("t.shp", second_points + 16 * 2 + 8, bytes_of(std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(mentions(read_error(path("t.shp")), {"vertex 2", "y is infinite"}));
  patch("t.shp", second_points + 16 * 2 + 8, bytes_of(1e120));
  EXPECT_TRUE(mentions(read_error(path("t.shp")), {"vertex 2", "domain"}));
}

// Two outer rings, a hole, and a ring that GDAL would have to guess about: one record, one polygon.
TEST_F(Shapefile, RingsOfARecordAreOnePolygonInTheFilesOrder) {
  const RegionSet record{
      {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {20, 0}, {21, 1}, {21, 0}, {2, 2}, {6, 2}, {6, 6}}, {4, 7, 10}, {3}};
  write(path("r.shp"), record);
  const Layer layer = read_file(path("r.shp"));
  ASSERT_EQ(layer.regions.polygon_ends, (std::vector<std::uint32_t>{3}));
  EXPECT_EQ(layer.regions.contour_ends, record.contour_ends);
  EXPECT_EQ(layer.regions.points[4], (Point{20, 0}));
  EXPECT_EQ(layer.regions.points[7], (Point{2, 2}));
}

TEST_F(Shapefile, NullShapesAreCounted) {
  // Shape type 0 in the first record makes it a null shape; its remaining bytes are ignored.
  patch("a.shp", 100 + 8, std::string(4, '\0'));
  const Layer layer = read_file(path("a.shp"));
  EXPECT_EQ(layer.report.null_geometries, 1U);
  EXPECT_EQ(layer.features.front().feature, 1);
}

}  // namespace
}  // namespace oblast::io
