// `oblast dissolve`: groups, their order, and the functions of columns.
#include <gtest/gtest.h>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

using Words = std::vector<std::string>;

class Dissolve : public ::testing::Test {
 protected:
  Dissolve() {
    write_layer(folder_ / "in.geojson",
                {square(0, 1, R"("region":10,"name":null,"people":9007199254740993,"rate":0.5)"),
                 square(1, 1, R"("region":9,"name":"b","people":2,"rate":1.5)"),
                 square(2, 1, R"("region":9,"name":"a","people":null,"rate":0.25)"),
                 square(9, 1, R"("region":10,"name":"é","people":7,"rate":null)"),
                 square(5, 1, R"("region":null,"name":"n","people":1,"rate":null)"),
                 square(0, 0, R"("region":11,"name":"z","people":1,"rate":null)")});
  }

  ProgramRun run(const Words& more) {
    Words words{"dissolve", folder_.path("in.geojson"), "-o", folder_.path("out.geojson"), "--overwrite", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words);
  }
  Lines rows(const Words& more) {
    const ProgramRun done = run(more);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(oblast_program({"check", "--rows", folder_.path("out.geojson")}).code, 0);
    return rows_of(folder_.path("out.geojson")).rows;
  }

  Folder folder_;
};

TEST_F(Dissolve, WithoutColumnsGivesOneRowWithTheFirstValues) {
  EXPECT_EQ(rows({}), Lines{"region=10 name=b people=9007199254740993 rate=0.5 area=5"});
}

TEST_F(Dissolve, RowsAreInTheOrderOfNumbersWithNullLast) {
  EXPECT_EQ(
      rows({"--by", "region"}),
      (Lines{"region=9 name=b people=2 rate=1.5 area=2", "region=10 name=é people=9007199254740993 rate=0.5 area=2",
             "region=11 name=z people=1 rate=null area=0", "region=null name=n people=1 rate=null area=1"}));
}

TEST_F(Dissolve, TextIsOrderedByBytes) {
  EXPECT_EQ(rows({"--by", "name", "--select", "name"}), (Lines{"name=a area=1", "name=b area=1", "name=n area=1",
                                                               "name=z area=0", "name=é area=1", "name=null area=1"}));
}

TEST_F(Dissolve, SeveralColumnsMakeTheGroups) {
  EXPECT_EQ(rows({"--by", "region,rate", "--agg", "people:count"}),
            (Lines{"region=9 rate=0.25 people=0 area=1", "region=9 rate=1.5 people=1 area=1",
                   "region=10 rate=0.5 people=1 area=1", "region=10 rate=null people=1 area=1",
                   "region=11 rate=null people=1 area=0", "region=null rate=null people=1 area=1"}));
}

TEST_F(Dissolve, FunctionsMakeTheColumns) {
  EXPECT_EQ(rows({"--by", "region", "--where", "region < 11", "--agg", "people:sum,people:list", "--agg", "rate:mean",
                  "--agg", "name:min,name:max,name:first,name:last,name:count"}),
            (Lines{"region=9 people_sum=2 people_list=[2] rate=0.875 name_min=a name_max=b name_first=b name_last=a "
                   "name_count=2 area=2",
                   "region=10 people_sum=9007199254741000 people_list=[9007199254740993,7] rate=0.5 name_min=é "
                   "name_max=é name_first=é name_last=é name_count=1 area=2"}));
}

TEST_F(Dissolve, FaultsNameTheColumn) {
  const ProgramRun sum = run({"--agg", "name:sum"});
  EXPECT_EQ(sum.code, 1);
  EXPECT_TRUE(contains(sum.err, "column name has text")) << sum.err;
  const ProgramRun missing = run({"--by", "country"});
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(contains(missing.err, "no column country") && contains(missing.err, "in.geojson")) << missing.err;
  const ProgramRun function = run({"--agg", "name:median"});
  EXPECT_EQ(function.code, 2);
  EXPECT_TRUE(contains(function.err, "people:sum")) << function.err;
}

TEST_F(Dissolve, ASumThatIsTooLargeIsAnError) {
  write_layer(folder_ / "in.geojson",
              {square(0, 1, R"("n":9223372036854775807)"), square(1, 1, R"("n":9223372036854775807)")});
  const ProgramRun sum = run({"--agg", "n:sum"});
  EXPECT_EQ(sum.code, 1);
  EXPECT_TRUE(contains(sum.err, "the sum of n")) << sum.err;
}

TEST_F(Dissolve, ColumnsOfSeveralFilesAreJoinedByName) {
  write_layer(folder_ / "more.geojson", {square(20, 1, R"("name":5,"extra":true)")});
  const ProgramRun done = oblast_program({"dissolve", folder_.path("in.geojson"), folder_.path("more.geojson"), "--by",
                                          "name", "-o", folder_.path("out.gpkg"), "-q"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(contains(done.err, "name has text in") && contains(done.err, "it is read as text")) << done.err;
  const RowsOfFile found = rows_of(folder_.path("out.gpkg"));
  EXPECT_EQ(found.rows.at(0), "name=5 region=null people=null rate=null extra=1 area=1");
  EXPECT_EQ(found.rows.at(1), "name=a region=9 people=null rate=0.25 extra=null area=1");
}

}  // namespace
}  // namespace oblast::test
