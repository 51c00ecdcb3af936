// `oblast repair`: rows, attributes, the report, and files that need no repair.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;

std::string feature(const std::string& coordinates, const std::string& properties) {
  return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":"Polygon","coordinates":)" +
         coordinates + "}}";
}

class Repair : public ::testing::Test {
 protected:
  Repair() {
    write_layer(
        folder_ / "in.geojson",
        {feature("[[[0,0],[4,4],[4,0],[0,4],[0,0]]]", R"("name":"bowtie","n":1)"),
         feature("[[[20,1],[20,0],[21,0],[21,1],[20,1]]]", R"("name":"valid","n":null)"),
         feature("[[[30,0],[31,0],[32,0],[30,0]]]", R"("name":"flat","n":3)"), square(0, 0, R"("name":"null","n":4)")});
    write_layer(folder_ / "coverage.geojson",
                {square(0, 4, R"("name":"a")"), square(3, 4, R"("name":"b")"), square(7, 4, R"("name":"c")")});
  }

  ProgramRun run(const std::string& input, const Words& more, const std::string& output = "out.geojson") {
    Words words{"repair", folder_.path(input), "-o", folder_.path(output), "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words);
  }
  Lines rows(const std::string& output = "out.geojson") { return rows_of(folder_.path(output)).rows; }

  Folder folder_;
};

TEST_F(Repair, KeepsRowsAndAttributesAndSaysWhatChanged) {
  const ProgramRun done = run("in.geojson", {});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(rows(), (Lines{"name=bowtie n=1 area=8", "name=valid n=null area=1", "name=flat n=3 area=0",
                           "name=null n=4 area=0"}));
  EXPECT_TRUE(contains(done.err, "  repaired  2 of 4 features changed; 1 left without a geometry\n")) << done.err;
  EXPECT_TRUE(contains(done.err, "    feature 0: two edges of a ring cross; 1 ring before, 2 rings after\n"))
      << done.err;
  EXPECT_TRUE(
      contains(done.err, "    feature 2: all points of a ring are on one line; 1 ring before, nothing is left\n"))
      << done.err;
  EXPECT_FALSE(contains(done.err, "noding")) << done.err;
  // The valid one still runs clockwise from its own first vertex.
  EXPECT_TRUE(contains(read_file(folder_ / "out.geojson"), "[20,1],[20,0],[21,0],[21,1],[20,1]"))
      << read_file(folder_ / "out.geojson");
}

TEST_F(Repair, LeavesARepairedFileAsItIs) {
  for (const char* format : {"geojson", "gpkg", "shp", "wkt"}) {
    const std::string first = std::string("first.") + format, second = std::string("second.") + format;
    ASSERT_EQ(run("in.geojson", {"--drop-empty"}, first).code, 0);
    const ProgramRun again = run(first, {}, second);
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(contains(again.err, "  repaired  0 of 2 features changed\n")) << again.err;
    EXPECT_EQ(rows(first), rows(second));
    ASSERT_EQ(run(first, {}, "first.wkt").code, 0);
    ASSERT_EQ(run(second, {}, "second.wkt").code, 0);
    EXPECT_EQ(read_file(folder_ / "first.wkt"), read_file(folder_ / "second.wkt")) << format;
  }
}

TEST_F(Repair, LeavesOutRowsWithoutGeometry) {
  const ProgramRun done = run("in.geojson", {"--drop-empty", "--select", "name"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(rows(), (Lines{"name=bowtie area=8", "name=valid area=1"}));
  EXPECT_TRUE(contains(done.err, "; 2 rows without a geometry left out\n")) << done.err;
}

TEST_F(Repair, ReportsAsJson) {
  const ProgramRun done = run("in.geojson", {"--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const auto report = nlohmann::json::parse(done.out);
  ASSERT_EQ(report["changes"].size(), 2U);
  EXPECT_EQ(report["changes"][0]["feature"], 0);
  EXPECT_EQ(report["changes"][0]["faults"][0], "two edges of a ring cross");
  EXPECT_EQ(report["changes"][0]["area_after"], 8);
  EXPECT_EQ(report["changes"][1]["rings_dropped"], 1);
  EXPECT_EQ(report["features_without_geometry"].size(), 2U);
  EXPECT_EQ(report["result"]["polygons"], 3);
  EXPECT_FALSE(report.contains("gaps_left"));
  EXPECT_EQ(report["result"]["area"], 9);
}

TEST_F(Repair, ListsTheFirstTwentyChanges) {
  std::vector<std::string> features;
  for (int i = 0; i < 25; ++i) features.push_back(feature("[[[0,0],[4,4],[4,0],[0,4],[0,0]]]", R"("name":"x")"));
  write_layer(folder_ / "many.geojson", features);
  const ProgramRun done = run("many.geojson", {});
  EXPECT_TRUE(contains(done.err, "    feature 19: ")) << done.err;
  EXPECT_FALSE(contains(done.err, "    feature 20: ")) << done.err;
  EXPECT_TRUE(contains(done.err, "    and 5 more; --json lists all\n")) << done.err;
  EXPECT_EQ(nlohmann::json::parse(run("many.geojson", {"--json"}).out)["changes"].size(), 25U);
  EXPECT_EQ(run("many.geojson", {"-q"}).err, "");
}

TEST_F(Repair, MakesACoverage) {
  const ProgramRun done = run("coverage.geojson", {"--coverage"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(rows(), (Lines{"name=a area=16", "name=b area=12", "name=c area=16"}));
  EXPECT_TRUE(contains(done.err, "1 overlap removed, 0 gaps closed, 0 gaps left, 0 slivers moved; ")) << done.err;
  EXPECT_TRUE(contains(done.err, "    overlap of feature 1 at (3 0), area 4: now in feature 0\n")) << done.err;
  EXPECT_EQ(run("coverage.geojson", {"--coverage", "--overlaps", "largest"}).code, 0);
}

TEST_F(Repair, ClosesGapsAndMovesSlivers) {
  // A frame with a gap of 2 x 2 in it, and a feature with a small part in a corner of the gap.
  write_layer(folder_ / "frame.geojson",
              {feature("[[[0,0],[9,0],[9,9],[0,9],[0,0]],[[1,1],[1,3],[3,3],[3,1],[1,1]]]", R"("name":"frame")"),
               R"({"type":"Feature","properties":{"name":"two"},"geometry":{"type":"MultiPolygon","coordinates":)"
               R"([[[[20,0],[24,0],[24,4],[20,0]]],[[[1,1],[2,1],[1,2],[1,1]]]]}})"});
  const ProgramRun done = run("frame.geojson", {"--coverage", "--gaps-below", "inf", "--slivers-narrower", "1"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(rows(), (Lines{"name=frame area=81", "name=two area=8"}));
  EXPECT_TRUE(
      contains(done.err, "0 overlaps removed, 1 gap closed, 0 gaps left, 1 sliver moved; 2 of 2 features changed"))
      << done.err;
  const auto report = nlohmann::json::parse(run("frame.geojson", {"--coverage", "--json"}).out);
  EXPECT_EQ(report["gaps_left"], 1);
  EXPECT_EQ(run("frame.geojson", {"--coverage", "--gaps-narrower", "0.1", "--slivers-below", "0.1"}).code, 0);
  EXPECT_EQ(rows(), (Lines{"name=frame area=77", "name=two area=8.5"}));
}

TEST_F(Repair, ExplainsErrorsOfTheCall) {
  const auto says = [&](const Words& words, const std::string& what) {
    const ProgramRun done = run("coverage.geojson", words);
    EXPECT_EQ(done.code, 2) << done.err;
    EXPECT_TRUE(contains(done.err, what)) << done.err;
  };
  says({"--gaps-below", "1"}, "--gaps-below is for coverages; add --coverage");
  says({"--coverage", "--overlaps", "smallest"}, "smallest is not a rule; choose first or largest");
  says({"--coverage", "--gaps-below", "-1"}, "the bound must be 0 or more");
  says({"--coverage", "--slivers-below", "nan"}, "the bound must be 0 or more");
  says({"--minimal"}, "--minimal");
}

TEST_F(Repair, ReadsAndWritesStandardStreams) {
  const ProgramRun done = oblast_program({"repair", "-", "-o", "-", "-q"},
                                         "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\nPOLYGON ((9 9, 8 9, 8 8, 9 9))\n");
  EXPECT_EQ(done.out,
            "MULTIPOLYGON (((0 0, 2 2, 0 4, 0 0)), ((2 2, 4 0, 4 4, 2 2)))\nMULTIPOLYGON (((9 9, 8 9, 8 8, 9 9)))\n");
}

}  // namespace
}  // namespace oblast::test
