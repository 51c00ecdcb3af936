// Numbers have units, plurals are right, and what cannot be read says why.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

std::string crs_layer(int code, double x, double y, double w) {
  return fmt::format(
      R"({{"type":"FeatureCollection","crs":{{"type":"name","properties":{{"name":"urn:ogc:def:crs:EPSG::{0}"}}}},)"
      R"("features":[{{"type":"Feature","properties":{{}},"geometry":{{"type":"Polygon","coordinates":)"
      R"([[[{1},{2}],[{3},{2}],[{3},{4}],[{1},{4}],[{1},{2}]]]}}}}]}})",
      code, x, y, x + w, y + w);
}

TEST(Messages, AreasHaveTheUnitOfTheCoordinateSystem) {
  const Folder folder;
  const auto area = [&](int code, double x, double y, double w) {
    write_file(folder / "in.geojson", crs_layer(code, x, y, w));
    const ProgramRun run = oblast_program({"union", folder.path("in.geojson"), "-o", "-"});
    EXPECT_EQ(run.code, 0) << run.err;
    const std::size_t at = run.err.find("area ");
    return run.err.substr(at, run.err.find(';', at) - at);
  };
  // pyproj's Geod.polygon_area_perimeter: 12308778361.47 and 797383.0 m2.
  EXPECT_EQ(area(4326, 0, 0, 1), "area      12308.8 km2 on the ellipsoid");
  EXPECT_EQ(area(4326, 8, 50, 0.01), "area      797383 m2 on the ellipsoid");
  EXPECT_EQ(area(3035, 4000000, 3000000, 20), "area      400 m2");
  EXPECT_EQ(area(2225, 6000000, 2000000, 20), "area      400 US survey ft2");
  const ProgramRun none = oblast_program({"union", "-", "-o", "-"}, "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  EXPECT_TRUE(contains(none.err, "area      4 square units of the coordinates; coordinate system: none")) << none.err;
}

TEST(Messages, OneIsSingular) {
  const Folder folder;
  const ProgramRun run = oblast_program({"union", "-", "-o", folder.path("u.wkt"), "--svg", folder.path("u.svg")},
                                        "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  EXPECT_TRUE(contains(run.err, "1 file, 1 feature, 1 contour, 4 vertices")) << run.err;
  EXPECT_TRUE(contains(run.err, "0 intersections, 1 round,")) << run.err;
  EXPECT_FALSE(contains(read_file(folder / "u.svg"), "1 polygons"));
}

TEST(Messages, WhatCannotBeReadSaysWhyAndIsExitCodeTwo) {
  const Folder folder;
  write_file(folder / "plain.wkt", "POLYGON EMPTY");
  fs::create_symlink("loop.gpkg", folder / "loop.gpkg");
  const std::pair<std::string, std::string> inputs[] = {
      {"none.gpkg", "no such file or folder"},
      {"loop.gpkg", "Too many levels of symbolic links"},
      {std::string(300, 'x') + ".shp", "File name too long"},
  };
  for (const auto& [name, why] : inputs) {
    const Words calls[] = {{"union", folder.path(name), "-o", folder.path("o.gpkg")},
                           {"clip", folder.path("plain.wkt"), folder.path(name), "-o", folder.path("o.gpkg")}};
    for (const Words& call : calls) {
      const ProgramRun run = oblast_program(call);
      EXPECT_EQ(run.code, 2) << run.err;
      EXPECT_TRUE(contains(run.err, why) && contains(run.err, name)) << run.err;
      EXPECT_EQ(run.err.find(why), run.err.rfind(why)) << "twice: " << run.err;
    }
  }
}

TEST(Messages, APermissionThatIsMissingIsNamed) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const Folder folder;
  for (const char* const name : {"secret.wkt", "secret.geojson"}) {
    write_file(folder / name, "POLYGON EMPTY");
    fs::permissions(folder / name, fs::perms::none);
    const ProgramRun run = oblast_program({"union", folder.path(name), "-o", folder.path("o.gpkg")});
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, "Permission denied") && contains(run.err, name)) << run.err;
  }
}

TEST(Messages, ThreadsOutOfRangeNameTheRange) {
  for (const char* const word : {"100000", "1025", "-1", "many", "2.5", "99999999999999999999"}) {
    const ProgramRun run = oblast_program({"union", "-", "-o", "-", "--threads", word}, "POLYGON EMPTY");
    EXPECT_EQ(run.code, 2) << word;
    EXPECT_TRUE(contains(run.err, fmt::format("'{}' is not a number of threads; write a number from 1 to 1024", word)))
        << run.err;
  }
  EXPECT_EQ(oblast_program({"union", "-", "-o", "-", "--threads", "1024"}, "POLYGON EMPTY").code, 0);
}

}  // namespace
}  // namespace oblast::test
