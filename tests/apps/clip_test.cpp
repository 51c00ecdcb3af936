// `oblast clip` and `oblast erase`: rows and columns of IN stay, and the other layer is one area.
#include <gtest/gtest.h>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;

class Clip : public ::testing::Test {
 protected:
  Clip() {
    write_layer(folder_ / "in.geojson",
                {square(0, 4, R"("name":"a","people":5)"), square(2, 4, R"("name":"b","people":null)"),
                 square(20, 1, R"("name":"far","people":1)"), square(0, 0, R"("name":"none")")});
    // The second row lies in the first one, the third overlaps the first.
    write_layer(folder_ / "other.geojson",
                {square(1, 4, R"("zone":1,"name":"w")"), square(2, 2, R"("zone":2,"name":"w")"),
                 square(4, 3, R"("zone":3,"name":"w")")});
  }

  ProgramRun run(const std::string& command, const Words& more = {}) {
    Words words{command, folder_.path("in.geojson"),  folder_.path("other.geojson"),
                "-o",    folder_.path("out.geojson"), "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words);
  }
  RowsOfFile rows(const std::string& command, Words more = {}) {
    more.push_back("-q");
    const ProgramRun done = run(command, more);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(oblast_program({"check", "--rows", folder_.path("out.geojson")}).code, 0);
    return rows_of(folder_.path("out.geojson"));
  }

  Folder folder_;
};

// Of a, [1, 4] x [0, 4] is inside. Of b, [2, 5] x [0, 4] and [5, 6] x [0, 3].
TEST_F(Clip, KeepsEachRowOnceHoweverTheRowsOfTheWindowOverlap) {
  const RowsOfFile found = rows("clip");
  EXPECT_EQ(found.rows, (Lines{"name=a people=5 area=12", "name=b people=null area=15"}));
  EXPECT_EQ(found.columns, "name: text, people: 32-bit integers");
}

TEST_F(Clip, EraseKeepsTheRestAndTheRowsFarAway) {
  EXPECT_EQ(rows("erase").rows,
            (Lines{"name=a people=5 area=4", "name=b people=null area=1", "name=far people=1 area=1"}));
}

TEST_F(Clip, TheInnerBordersOfTheWindowLeaveNoVertices) {
  write_file(folder_ / "in.wkt", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))");
  write_file(folder_ / "window.wkt", "POLYGON ((1 1, 4 1, 4 4, 1 4, 1 1))\nPOLYGON ((4 1, 8 1, 8 4, 4 4, 4 1))");
  EXPECT_EQ(oblast_program({"clip", folder_.path("in.wkt"), folder_.path("window.wkt"), "-o", "-", "--minimal"}).out,
            "MULTIPOLYGON (((1 1, 8 1, 8 4, 1 4, 1 1)))\n");
}

TEST_F(Clip, ConditionsAreForEachLayerAndColumnsAreThoseOfIn) {
  EXPECT_EQ(rows("clip", {"--where", "name = 'b'", "--where-window", "zone = 2"}).rows,
            Lines{"name=b people=null area=4"});
  EXPECT_EQ(rows("erase", {"--where-mask", "zone = 3", "--select", "name", "--area", "m2"}).rows,
            (Lines{"name=a m2=16 area=16", "name=b m2=10 area=10", "name=far m2=1 area=1"}));
  const ProgramRun wrong = run("clip", {"--select", "zone"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_TRUE(contains(wrong.err, "no column zone; choose from name, people")) << wrong.err;
}

TEST_F(Clip, AnEmptyWindowKeepsNothingAndAnEmptyMaskAll) {
  EXPECT_EQ(rows("clip", {"--where-window", "zone = 9"}).rows, Lines{});
  EXPECT_EQ(rows("erase", {"--where-mask", "zone = 9"}).rows.size(), 3u);
}

}  // namespace
}  // namespace oblast::test
