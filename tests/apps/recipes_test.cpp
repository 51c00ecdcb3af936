// Runs every command of `oblast help recipes`, in order, as a user would type it, and compares what it gives.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <map>
#include <sstream>

#include "apps/rows_support.h"

namespace oblast::test {
namespace {

namespace fs = std::filesystem;

class Recipes : public ::testing::Test {
 protected:
  Recipes() {
    write_file(folder_ / "nothing.wkt", "POLYGON EMPTY");
    layer("forests", {square(0, 4, R"("name":"old")"), square(20, 1, R"("name":"far")")});
    layer("regions", {square(2, 4, R"("name":"Picardie")"), square(0, 2, R"("name":"Alsace")")});
    layer("fields", {square(0, 4, R"("id":1)"), square(3, 2, R"("id":2)")});
    layer("flood", {square(0, 2, R"("level":7)")});
    layer("communes", {square(0, 1, R"("region":"A","people":3)"), square(1, 1, R"("region":"A","people":4)"),
                       square(5, 2, R"("region":"B","people":1)")});
    layer("landuse2010", {square(0, 2, R"("use":"forest")"), square(2, 2, R"("use":"field")")});
    layer("landuse2020",
          {square(0, 1, R"("use":"field")"), square(2, 2, R"("use":"field")"), square(6, 1, R"("use":"town")")});
    layer("soils", {square(1, 4, R"("soil":"clay")")});
    layer("parcels", {square(0, 40, R"("id":1)"), square(50, 20, R"("id":2)")});
    line_layer("roads", R"("name":"A1")", "[[0,0],[10000,0]]");
    line_layer("rivers", R"("name":"Oise")", "[[0,0],[100,0]]");
    const auto school = [](const std::string& name, const std::string& at) {
      return R"({"type":"Feature","properties":{"school":")" + name +
             R"("},"geometry":{"type":"Point","coordinates":)" + at + "}}";
    };
    write_layer(folder_ / "schools.geojson", {school("east", "[5,2]"), school("west", "[3,2]")});
    write_file(folder_ / "stops.geojson",
               R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[3,50]}})");
    fs::create_directory(folder_ / "fires");
    write_layer(folder_ / "fires/1.geojson", {square(0, 2, R"("day":1)"), square(0, 1, R"("day":1)")});
    write_layer(folder_ / "fires/2.geojson", {square(1, 2, R"("day":2)")});
  }

  // A GeoPackage; to erase nothing keeps every row as it is.
  void layer(const std::string& name, const std::vector<std::string>& features) {
    write_layer(folder_ / (name + ".geojson"), features);
    const ProgramRun run = oblast_program({"erase", folder_.path(name + ".geojson"), folder_.path("nothing.wkt"), "-o",
                                           folder_.path(name + ".gpkg"), "--assume-crs", "EPSG:3035", "-q"});
    EXPECT_EQ(run.code, 0) << run.err;
  }

  void line_layer(const std::string& name, const std::string& properties, const std::string& coordinates) {
    write_layer(folder_ / (name + ".geojson"),
                {R"({"type":"Feature","properties":{)" + properties +
                 R"(},"geometry":{"type":"LineString","coordinates":)" + coordinates + "}}"});
  }

  // In a shell, so that quotes mean what they mean to a user.
  void run(const std::string& line) {
    const std::string call = "cd '" + folder_.path("") + "' && PATH='" +
                             fs::path(OBLAST_PROGRAM).parent_path().string() + "':$PATH && " + line + " >>out 2>>err";
    const int status = std::system(call.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << line << "\n" << read_file(folder_ / "err");
  }

  Folder folder_;
};

std::vector<std::string> commands_of(const std::string& page) {
  std::vector<std::string> commands;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("    ")) commands.push_back(line.substr(4));
  return commands;
}

TEST_F(Recipes, GiveWhatTheySay) {
  const std::map<std::string, Lines> expected = {
      {"inside", {"name=old area=8"}},
      {"dry", {"id=1 m2=12 area=12", "id=2 m2=4 area=4"}},
      {"united", {"region=A people=7 area=2", "region=B people=1 area=4"}},
      {"days", {"depth=1 m2=4 area=4", "depth=2 m2=2 area=2"}},
      {"overlaps", {"polygon=0 area=2"}},
      {"parts",
       {"sources=fields:1 count=1 area=14", "sources=fields:1;fields:2 count=2 area=2",
        "sources=fields:2 count=1 area=2"}},
      {"clean", {"id=1 area=16", "id=2 area=2"}},
      {"both",
       {"use_1=forest use_2=field area=1", "use_1=forest use_2=null area=3", "use_1=field use_2=field area=4",
        "use_1=null use_2=town area=1"}},
      {"inner", {"id=1 area=400", "id=2 area=0"}},
      {"bank", {"name=Oise area=2000"}},
      {"served", {"school=east m2=8 area=8", "school=west m2=12 area=12"}},
      {"change", {"use_1=forest use_2=field m2=1 area=1"}},
      {"new", {"polygon=0 area=1"}},
      {"gone", {"polygon=0 area=3"}},
      {"soil_of_field", {"id=1 soil=clay m2=12 area=12", "id=1 soil=null m2=4 area=4", "id=2 soil=clay m2=4 area=4"}},
      {"pieces", {"use=field name=Alsace area=1", "use=field name=Picardie area=4"}},
      {"table", {"name=Alsace use=field m2=1 area=1", "name=Picardie use=field m2=4 area=4"}},
  };
  const std::string page = oblast_program({"help", "recipes"}).out;
  const std::vector<std::string> commands = commands_of(page);
  EXPECT_EQ(commands.size(), expected.size() + 5);  // two of them check, and three zones have round ends
  for (const std::string& line : commands) run(line);
  for (const auto& [name, rows] : expected) {
    EXPECT_TRUE(contains(page, "-o " + name + ".gpkg")) << name;
    EXPECT_EQ(rows_of(folder_.path(name + ".gpkg")).rows, rows) << name;
  }
  EXPECT_TRUE(contains(read_file(folder_ / "days.svg"), "</svg>"));
  const double road = 10000 * 1000 + 3.14159265 * 500 * 500;
  EXPECT_NEAR(area_of(folder_.path("near.gpkg")), road, 0.02 * road);
  EXPECT_EQ(rows_of(folder_.path("walk.geojson")).rows.size(), 1u);
  const double around = 50 * 50 + 30 * 30 - 2 * (100 - 3.14159265 * 25);
  EXPECT_NEAR(area_of(folder_.path("around.gpkg")), around, 0.1);
  EXPECT_TRUE(contains(read_file(folder_ / "around.svg"), "zones of parcels.gpkg"));
}

TEST(RecipesPage, IsThePageInTheDocuments) {
  EXPECT_EQ(read_file(fs::path(OBLAST_SOURCE_DIR) / "docs/recipes.md"), oblast_program({"help", "recipes"}).out)
      << "run: oblast help recipes > docs/recipes.md";
}

}  // namespace
}  // namespace oblast::test
