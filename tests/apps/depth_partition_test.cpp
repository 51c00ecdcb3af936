// `oblast depth` and `oblast partition`, and `oblast check --rows`.
#include <gtest/gtest.h>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

class Covers : public ::testing::Test {
 protected:
  Covers() {
    write_layer(folder_ / "a.geojson",
                {square(0, 4, R"("day":1)"), square(0, 2, R"("day":2)"), square(0, 1, R"("day":2)")});
    write_layer(folder_ / "b.geojson", {square(0, 0, R"("day":1)"), square(8, 1, R"("day":1)")});
  }

  Lines rows(std::vector<std::string> words) {
    words.insert(words.end(), {"-o", folder_.path("out.gpkg"), "--overwrite", "-q"});
    const ProgramRun done = oblast_program(words);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(oblast_program({"check", "--rows", folder_.path("out.gpkg")}).code, 0);
    return rows_of(folder_.path("out.gpkg")).rows;
  }

  Folder folder_;
};

TEST_F(Covers, DepthCountsFeaturesOrValues) {
  const std::string a = folder_.path("a.geojson"), b = folder_.path("b.geojson");
  EXPECT_EQ(rows({"depth", a, b}), (Lines{"depth=1 area=13", "depth=2 area=3", "depth=3 area=1"}));
  EXPECT_EQ(rows({"depth", a, b, "--by", "day"}), (Lines{"depth=1 area=13", "depth=2 area=4"}));
  EXPECT_EQ(rows({"depth", a, "--where", "day = 2", "--area", "m2"}),
            (Lines{"depth=1 m2=3 area=3", "depth=2 m2=1 area=1"}));
}

TEST_F(Covers, PartitionNamesTheSources) {
  EXPECT_EQ(rows({"partition", folder_.path("a.geojson"), folder_.path("b.geojson")}),
            (Lines{"sources=a:0 count=1 area=12", "sources=a:0;a:1 count=2 area=3",
                   "sources=a:0;a:1;a:2 count=3 area=1", "sources=b:1 count=1 area=1"}));
}

TEST_F(Covers, PartitionTellsFilesOfOneNameApart) {
  std::filesystem::create_directory(folder_ / "other");
  write_layer(folder_ / "other/a.geojson", {square(50, 1, R"("day":1)")});
  const Lines found = rows({"partition", folder_.path("a.geojson"), folder_.path("other/a.geojson")});
  EXPECT_EQ(found.back(), "sources=" + folder_.path("other/a.geojson") + ":0 count=1 area=1");
}

TEST_F(Covers, UnionNamesTheFilesOfEachPart) {
  write_layer(folder_ / "c.geojson", {square(3, 2, R"("day":1)"), square(4, 2, R"("day":1)")});
  write_layer(folder_ / "none.geojson", {square(0, 0, R"("day":1)")});
  const std::vector<std::string> in{folder_.path("none.geojson"), folder_.path("a.geojson"), folder_.path("b.geojson"),
                                    folder_.path("c.geojson"), folder_.path("none.geojson")};
  std::vector<std::string> words{"union", "--source", "file"};
  words.insert(words.end(), in.begin(), in.end());
  EXPECT_EQ(rows(words), (Lines{"file=a area=14", "file=a;c area=2", "file=b area=1", "file=c area=4"}));
  words.insert(words.end(), {"-o", folder_.path("out.gpkg"), "--overwrite", "--fill", "evenodd"});
  const ProgramRun refused = oblast_program(words);
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(contains(refused.err, "--source")) << refused.err;
}

TEST_F(Covers, CheckOfRowsNamesFeaturePolygonAndVertex) {
  // The second row touches the side of the first one at (4, 1); the first has no vertex there.
  write_layer(folder_ / "bad.geojson", {square(0, 4, R"("n":1)"), square(4, 1, R"("n":2)")});
  const ProgramRun bad = oblast_program({"check", "--rows", folder_.path("bad.geojson")});
  EXPECT_EQ(bad.code, 1);
  EXPECT_TRUE(contains(bad.out, "another row") && contains(bad.out, "feature") && contains(bad.out, "vertex"))
      << bad.out;
  const ProgramRun json = oblast_program({"check", "--rows", "--json", folder_.path("bad.geojson")});
  EXPECT_EQ(json.code, 1);
  EXPECT_TRUE(contains(json.out, "\"rows_fit\": false")) << json.out;
  EXPECT_EQ(oblast_program({"check", "--rows", "--canonical", folder_.path("bad.geojson")}).code, 2);
}

}  // namespace
}  // namespace oblast::test
