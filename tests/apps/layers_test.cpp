// `oblast layers` as a user runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/program_run.h"

namespace oblast::test {
namespace {

using Json = nlohmann::json;

constexpr const char* three_in_two_layers =
    "MULTIPOLYGON (((0 0, 2 0, 2 1, 0 1)), ((1 0, 4 0, 4 1, 1 1)), "
    "((3 0, 6 0, 6 1, 3 1)))";

TEST(LayersCommand, countsWhatGoesInTheLayersAndTheUnion) {
  const ProgramRun run = oblast_program({"layers", "-", "--json"}, three_in_two_layers);
  ASSERT_EQ(run.code, 0) << run.err;
  const Json groups = Json::parse(run.out)["groups"];
  ASSERT_EQ(groups.size(), 1u);  // one group has no row for all
  EXPECT_EQ(groups[0]["contours"], 3);
  EXPECT_EQ(groups[0]["vertices"], 12);
  EXPECT_EQ(groups[0]["layers"], 2);
  EXPECT_EQ(groups[0]["result_contours"], 1);
}

// A month is the same alone or with others, so grouping by name equals grouping by folder.
TEST(LayersCommand, groupsFilesByTheBeginningOfTheirNames) {
  const Folder folder;
  const std::string fires = folder.path("fires"), july = folder.path("july");
  ASSERT_EQ(oblast_program({"generate", "fires", "--scale", "0.02", "-o", fires, "-q"}).code, 0);
  ASSERT_EQ(oblast_program({"generate", "fires", "--scale", "0.02", "--month", "july", "-o", july, "-q"}).code, 0);
  const ProgramRun all = oblast_program({"layers", fires, "--prefix", "13", "--json"});
  const ProgramRun alone = oblast_program({"layers", july, "--json"});
  ASSERT_EQ(all.code, 0) << all.err;
  ASSERT_EQ(alone.code, 0) << alone.err;
  const Json months = Json::parse(all.out)["groups"], one = Json::parse(alone.out)["groups"][0];
  ASSERT_EQ(months.size(), 7u);
  EXPECT_EQ(months[3]["group"], "fires-2011-07");
  for (const char* key : {"files", "contours", "vertices", "layers", "result_contours", "result_vertices"})
    EXPECT_EQ(months[3][key], one[key]) << key;
  EXPECT_EQ(months[6]["group"], "all");
  for (const char* key : {"files", "contours", "vertices"}) {
    int sum = 0;
    for (int month = 0; month < 6; ++month) sum += months[month][key].get<int>();
    EXPECT_EQ(months[6][key], sum) << key;
  }
}

}  // namespace
}  // namespace oblast::test
