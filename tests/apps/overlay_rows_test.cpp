// `oblast overlay` with rows: keys, columns of both layers, options, and what needs --merge.
#include <gtest/gtest.h>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;

class OverlayRows : public ::testing::Test {
 protected:
  OverlayRows() {
    write_layer(folder_ / "a.geojson", {square(0, 2, R"("name":"west","n":1)"), square(2, 2, R"("name":null,"n":2)"),
                                        square(0, 0, R"("name":"nowhere","n":3)")});
    write_layer(folder_ / "b.geojson",
                {square(1, 2, R"("name":"zone","code":1.5)"), square(9, 1, R"("name":"far","code":2.5)")});
  }

  ProgramRun run(const std::string& operation, const Words& more = {}, const std::string& out = "out.geojson") {
    Words words{"overlay",     operation, folder_.path("a.geojson"), folder_.path("b.geojson"), "-o", folder_.path(out),
                "--overwrite", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words);
  }
  Lines rows(const std::string& operation, const Words& more = {}) {
    const ProgramRun done = run(operation, more);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(oblast_program({"check", "--rows", folder_.path("out.geojson")}).code, 0);
    return rows_of(folder_.path("out.geojson")).rows;
  }

  Folder folder_;
};

const std::string both_west = "name_1=west n=1 name_2=zone code=1.5 area=2",
                  both_east = "name_1=null n=2 name_2=zone code=1.5 area=2",
                  only_west = "name_1=west n=1 name_2=null code=null area=2",
                  only_east = "name_1=null n=2 name_2=null code=null area=2",
                  only_far = "name_1=null n=null name_2=far code=2.5 area=1";

TEST_F(OverlayRows, HaveTheColumnsOfBothLayers) {
  EXPECT_EQ(rows("union"), (Lines{both_west, only_west, both_east, only_east, only_far}));
  EXPECT_EQ(rows_of(folder_.path("out.geojson")).columns,
            "name_1: text, n: 32-bit integers, name_2: text, code: numbers");
  EXPECT_EQ(rows("identity"), (Lines{both_west, only_west, both_east, only_east}));
  EXPECT_EQ(rows("intersection"), (Lines{both_west, both_east}));
  EXPECT_EQ(rows("symdifference"), (Lines{only_west, only_east, only_far}));
}

TEST_F(OverlayRows, OfADifferenceHaveTheColumnsOfA) {
  const Lines found = rows("difference");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(contains(found[0], "name=west n=1")) << found[0];
  EXPECT_FALSE(contains(found[0], "code")) << found[0];
  EXPECT_TRUE(contains(found[0], "area=2")) << found[0];
}

TEST_F(OverlayRows, APictureIsColouredByAColumn) {
  const std::string picture = folder_.path("rows.svg");
  ASSERT_EQ(run("union", {"--svg", picture, "--colour", "n"}).code, 0);
  EXPECT_TRUE(contains(read_file(picture), ">1</text>") && contains(read_file(picture), ">2</text>")) << "the legend";
  const ProgramRun unknown = run("union", {"--svg", picture, "--overwrite", "--colour", "m"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(contains(unknown.err, "no column m; choose from")) << unknown.err;
  const ProgramRun nothing_to_draw = run("union", {"--colour", "n"});
  EXPECT_EQ(nothing_to_draw.code, 2);
  EXPECT_TRUE(contains(nothing_to_draw.err, "add --svg")) << nothing_to_draw.err;
}

TEST_F(OverlayRows, ConditionsChooseFeatures) {
  EXPECT_EQ(rows("intersection", {"--where-a", "n > 1"}), Lines{both_east});
  EXPECT_EQ(rows("intersection", {"--where", "name = 'west' OR name = 'zone'"}), Lines{both_west});
  const ProgramRun bad = run("union", {"--where", "n >< 1"});
  EXPECT_EQ(bad.code, 1);
  EXPECT_TRUE(contains(bad.err, "a.geojson") && contains(bad.err, "n >< 1") && contains(bad.err, "syntax error"))
      << bad.err;
}

TEST_F(OverlayRows, SelectKeepsTheColumnsNamed) {
  EXPECT_EQ(rows("intersection", {"--select", "n,code"}), (Lines{"n=1 code=1.5 area=2", "n=2 code=1.5 area=2"}));
  const ProgramRun bad = run("union", {"--select", "m"});
  EXPECT_EQ(bad.code, 1);
  EXPECT_TRUE(contains(bad.err, "no column m") && contains(bad.err, "name, n, name, code")) << bad.err;
}

TEST_F(OverlayRows, MeasuresAreColumnsWithTheirUnits) {
  const ProgramRun done = run("intersection", {"--select", "n", "--area", "m2", "--perimeter", "m", "--json"});
  EXPECT_EQ(done.err, "");
  EXPECT_TRUE(contains(done.out, "column m2 is in m2")) << done.out;
  EXPECT_EQ(rows_of(folder_.path("out.geojson")).rows, (Lines{"n=1 m2=2 m=6 area=2", "n=2 m2=2 m=6 area=2"}));
  EXPECT_EQ(run("union", {"--area", "n"}).code, 2);
}

TEST_F(OverlayRows, AreaOfLongitudesAndLatitudesIsOnTheEllipsoid) {
  // A square degree at the equator, by PROJ and by hand: 110574 m times 111320 m.
  const std::string feature = square(0, 1, R"("n":1)");
  write_file(folder_ / "degrees.geojson", R"({"type":"FeatureCollection","features":[)" + feature + "]}");
  const ProgramRun done =
      oblast_program({"dissolve", folder_.path("degrees.geojson"), "-o", folder_.path("d.geojson"), "--area", "m2"});
  EXPECT_TRUE(contains(done.err, " is in m2 on the ellipsoid")) << done.err;
  const std::string row = rows_of(folder_.path("d.geojson")).rows.at(0);
  EXPECT_NEAR(std::stod(row.substr(row.find("m2=") + 3)), 110574.0 * 111320.0 * 0.99995, 5e5) << row;
}

TEST_F(OverlayRows, WhatReadsWholeOperandsNeedsMerge) {
  for (const Words& words : {Words{"--engine", "vatti"}, Words{"--fill", "evenodd"}, Words{"--fill-b", "nonzero"}}) {
    const ProgramRun refused = run("union", words, "merged.geojson");
    EXPECT_EQ(refused.code, 2) << words[0];
    EXPECT_TRUE(contains(refused.err, "--merge")) << refused.err;
    Words merged = words;
    merged.push_back("--merge");
    EXPECT_EQ(run("union", merged, "merged.geojson").code, 0);
  }
  const ProgramRun identity = run("identity", {"--merge"});
  EXPECT_EQ(identity.code, 2);
  EXPECT_TRUE(contains(identity.err, "oblast union A")) << identity.err;
  EXPECT_EQ(run("union", {"--merge", "--select", "n"}).code, 2);
}

TEST_F(OverlayRows, OfWktHaveNoAttributes) {
  const ProgramRun done = run("intersection", {}, "out.wkt");
  EXPECT_TRUE(contains(done.err, "WKT has no attributes; 4 columns are left out")) << done.err;
  EXPECT_EQ(read_file(folder_ / "out.wkt"),
            "MULTIPOLYGON (((1 0, 2 0, 2 2, 1 2, 1 0)))\nMULTIPOLYGON (((2 0, 3 0, 3 2, 2 2, 2 0)))\n");
  EXPECT_EQ(oblast_program({"overlay", "union", folder_.path("out.wkt"), folder_.path("out.wkt"), "-o",
                            folder_.path("again.gpkg"), "-q"})
                .code,
            0);
  EXPECT_EQ(rows_of(folder_.path("again.gpkg")).rows, (Lines{"area=2", "area=2"}));
}

TEST_F(OverlayRows, SummaryCountsRowsAndColumns) {
  const ProgramRun done = run("union", {"--json"});
  EXPECT_TRUE(contains(done.out, "\"rows\": 5") && contains(done.out, "\"columns\": 4")) << done.out;
}

TEST_F(OverlayRows, CanBeDrawn) {
  EXPECT_EQ(run("union", {"--svg", folder_.path("p.svg")}).code, 0);
  EXPECT_TRUE(contains(read_file(folder_ / "p.svg"), "union of a.geojson and b.geojson"));
}

}  // namespace
}  // namespace oblast::test
