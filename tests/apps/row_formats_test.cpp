// Rows with every type of attribute, written in every format and read back; what a format cannot hold is said.
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

// Two features of all types, with an island in a hole, and nulls.
class RowFormats : public ::testing::TestWithParam<const char*> {
 protected:
  RowFormats() {
    const std::string ring = R"([[0.1,0],[9,0],[9,9],[0,9],[0.1,0]],[[1,1],[1,8],[8,8],[8,1],[1,1]])";
    write_layer(
        folder_ / "in.geojson",
        {R"({"type":"Feature","properties":{"náme":"Žilina \"x\"","id_of_the_region":1099511627776,)"
         R"("id_of_the_road":-5,"ratio":0.1,"open":true,"day":"2020-02-29","at":"2020-02-29T23:59:58.250Z",)"
         R"("clock":"12:30:00","whole":[1,2],"parts":[0.5,2.0],"words":["a","ß,"],"fid":3},)"
         R"("geometry":{"type":"MultiPolygon","coordinates":[[)" +
             ring + R"(],[[[2,2],[3,2],[3,3],[2,2]]]]}})",
         R"({"type":"Feature","properties":{"náme":null,"id_of_the_region":null,"id_of_the_road":null,)"
         R"("ratio":null,"open":null,"day":null,"at":null,"clock":null,"whole":null,"parts":null,)"
         R"("words":null,"fid":4},"geometry":{"type":"Polygon","coordinates":[[[20,0],[21,0],[21,1],[20,0]]]}})"});
  }

  ProgramRun write(const std::string& name) {
    return oblast_program({"dissolve", folder_.path("in.geojson"), "--by", "fid", "-o", folder_.path(name), "-q"});
  }

  Folder folder_;
};

TEST_P(RowFormats, KeepValuesNamesAndGeometry) {
  const std::string extension = GetParam(), name = std::string("out.") + GetParam();
  const ProgramRun done = write(name);
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(oblast_program({"check", "--rows", folder_.path(name)}).code, 0);
  RowsOfFile found = rows_of(folder_.path(name));
  std::sort(found.rows.begin(), found.rows.end());  // FlatGeobuf sorts by place
  const bool shapefile = extension == "shp", fgb = extension == "fgb", text = extension != "geojson";
  const std::string region = shapefile ? "id_of_the_" : "id_of_the_region",
                    road = shapefile ? "id_of_th_1" : "id_of_the_road";
  const std::string day = fgb ? "2020-02-29T00:00:00" : "2020-02-29", open = "1";
  const std::string first =
      "fid=3 náme=Žilina \"x\" " + region + "=1099511627776 " + road + "=-5 ratio=0.1 open=" + open + " day=" + day +
      " at=2020-02-29T23:59:58.250Z clock=12:30:00 whole=[1,2] parts=[0.5,2] " + "words=[\"a\",\"ß,\"] area=" + "32.05";
  ASSERT_EQ(found.rows.size(), 2U);
  EXPECT_EQ(found.rows[0].substr(0, found.rows[0].find(" area=")), first.substr(0, first.find(" area=")));
  EXPECT_TRUE(contains(found.rows[1], "náme=null " + region + "=null " + road + "=null ratio=null open=null day=null"))
      << found.rows[1];
  const auto note = [&](const std::string& said) { return contains(done.err, "note: " + said); };
  EXPECT_EQ(note("whole is written as text"), text) << done.err;
  EXPECT_EQ(note("clock is written as text"), text) << done.err;
  EXPECT_EQ(note("day is written as dates with time"), fgb) << done.err;
  EXPECT_EQ(note("at is written as text"), shapefile) << done.err;
  EXPECT_EQ(note("id_of_the_region is written as id_of_the_ (Shapefile names have 10 bytes)"), shapefile) << done.err;
  EXPECT_EQ(note("id_of_the_region is written as a number of 18 digits"), shapefile) << done.err;
  EXPECT_EQ(note("open is written as 32-bit integers"), shapefile) << done.err;
  if (!text) {
    EXPECT_EQ(done.err, "");
  }
}

TEST_P(RowFormats, ReadBackAsTheyWereWritten) {
  const std::string name = std::string("out.") + GetParam(), again = std::string("again.") + GetParam();
  ASSERT_EQ(write(name).code, 0);
  const ProgramRun done =
      oblast_program({"dissolve", folder_.path(name), "--by", "fid", "-o", folder_.path(again), "-q"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(rows_of(folder_.path(name)).columns, rows_of(folder_.path(again)).columns);
  EXPECT_EQ(rows_of(folder_.path(name)).rows, rows_of(folder_.path(again)).rows);
}

TEST_P(RowFormats, RowsWithoutGeometryAreKeptOrRefused) {
  write_layer(folder_ / "in.geojson", {square(0, 0, R"("fid":1)"), square(0, 1, R"("fid":2)")});
  const std::string name = std::string("out.") + GetParam();
  const ProgramRun done = write(name);
  if (name == "out.fgb") {  // the format does not hold them
    EXPECT_EQ(done.code, 1);
    EXPECT_TRUE(contains(done.err, "row 0 has no polygons")) << done.err;
    return;
  }
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(rows_of(folder_.path(name)).rows, (Lines{"fid=1 area=0", "fid=2 area=1"}));
}

TEST_P(RowFormats, AnOlderFileIsNotReplacedUnasked) {
  const std::string name = std::string("out.") + GetParam();
  ASSERT_EQ(write(name).code, 0);
  const std::string before = read_file(folder_ / name);
  EXPECT_EQ(write(name).code, 1);
  EXPECT_EQ(read_file(folder_ / name), before);
}

INSTANTIATE_TEST_SUITE_P(Formats, RowFormats, ::testing::Values("shp", "gpkg", "fgb", "geojson"),
                         [](const auto& format) { return std::string(format.param); });

TEST(RowsAsShapefile, LongTextIsAnErrorThatLeavesNothing) {
  const Folder folder;
  write_layer(folder / "in.geojson", {square(0, 1, "\"text\":\"" + std::string(300, 'x') + "\"")});
  const ProgramRun done = oblast_program({"dissolve", folder.path("in.geojson"), "-o", folder.path("out.shp"), "-q"});
  EXPECT_EQ(done.code, 1);
  EXPECT_TRUE(contains(done.err, "row 0, column text") && contains(done.err, "254")) << done.err;
  EXPECT_EQ(folder.names(), Lines{"in.geojson"});
}

TEST(RowsAsShapefile, ValuesThatLoseDigitsAreCounted) {
  const Folder folder;
  write_layer(folder / "in.geojson", {square(0, 1, R"("r":1e-30,"n":9223372036854775807,"e":"")")});
  const ProgramRun done = oblast_program({"dissolve", folder.path("in.geojson"), "-o", folder.path("out.shp"), "-q"});
  EXPECT_EQ(done.code, 0) << done.err;
  for (const char* column : {"r: 1 of the values", "n: 1 of the values", "e: 1 of the values"})
    EXPECT_TRUE(contains(done.err, column)) << done.err;
}

TEST(RowsAsGeopackage, NamesThatDifferInCaseOnlyAreMadeUnique) {
  const Folder folder;
  write_layer(folder / "in.geojson", {square(0, 1, R"("Name":1,"name":2,"geom":3)")});
  const ProgramRun done = oblast_program({"dissolve", folder.path("in.geojson"), "-o", folder.path("out.gpkg"), "-q"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(contains(done.err, "name is written as name_1")) << done.err;
  EXPECT_EQ(rows_of(folder.path("out.gpkg")).rows, Lines{"Name=1 name_1=2 geom=3 area=1"});
}

}  // namespace
}  // namespace oblast::test
