// `oblast check`: the files of tests/cases/faults with what the program says of them, and its other answers.
#include <gtest/gtest.h>
#include <oblast/check_features.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program_run.h"
#include "io/read.h"
#include "io/rows.h"
#include "io/write.h"

namespace oblast::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

const fs::path faults_folder = fs::path(OBLAST_SOURCE_DIR) / "tests" / "cases" / "faults";

/// The name of a file with a fault, from tests/cases/faults on: "features/spike.wkt".
std::vector<std::string> fault_files() {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(faults_folder))
    if (const auto extension = entry.path().extension(); extension == ".wkt" || extension == ".geojson")
      names.push_back(fs::relative(entry.path(), faults_folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

class FaultFile : public ::testing::TestWithParam<std::string> {
 protected:
  fs::path path() const { return faults_folder / GetParam(); }
  bool is_coverage() const { return GetParam().starts_with("coverage"); }
  /// What the program prints, from a .txt file beside the other one.
  std::string expected() const { return read_file(fs::path(path()).replace_extension(".txt")); }
};

TEST_P(FaultFile, ProgramSaysWhatIsExpected) {
  Words words{"check", path().string()};
  if (is_coverage()) words.push_back("--coverage");
  const ProgramRun run = oblast_program(words);
  EXPECT_EQ(run.out, expected());
  EXPECT_EQ(run.code, contains(expected(), "valid") ? 0 : 1);
  words.push_back("--json");
  const ProgramRun json = oblast_program(words);
  EXPECT_EQ(json.code, run.code);
  EXPECT_EQ(Json::parse(json.out)["valid"], run.code == 0);
}

TEST_P(FaultFile, LibraryFindsWhatTheProgramCounts) {
  const std::vector<std::string> paths{path().string()};
  io::ReadOptions read_options;
  read_options.entries = io::FeatureEntries::all;
  read_options.vertices = io::RingVertices::all;
  const io::Layer layer = io::read(paths, read_options);
  const std::vector<std::uint32_t> ends = io::feature_ends(layer);
  const FeatureView features{layer.regions, ends};
  FeatureCheckOptions options;
  options.open_contours = layer.open_contours;
  std::vector<FeatureFault> faults = check_features(features, options);
  if (is_coverage()) {
    const std::vector<FeatureFault> between = check_coverage(features);
    faults.insert(faults.end(), between.begin(), between.end());
  }
  std::map<std::string, int> counts;
  for (const FeatureFault& fault : faults) ++counts[name(fault.kind)];
  EXPECT_FALSE(counts.empty());
  for (const auto& [kind, count] : counts) {
    std::istringstream lines(expected());
    int expected_count = 0;
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("  " + kind + " ") && contains(line, "  in ")) {
        std::istringstream numbers(line.substr(32));
        numbers >> expected_count;
      }
    EXPECT_EQ(count, expected_count) << kind;
  }
}

INSTANTIATE_TEST_SUITE_P(Faults, FaultFile, ::testing::ValuesIn(fault_files()), [](const auto& tested) {
  std::string name = fs::path(tested.param).stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(CheckFeatures, ThereAreTwentySevenKindsOfFeatures) {
  const std::vector<std::string> files = fault_files();
  EXPECT_EQ(std::count_if(files.begin(), files.end(), [](const auto& f) { return f.starts_with("features"); }), 27);
}

TEST(CheckFeatures, AnOrdinaryCoverageIsValid) {
  const std::string two = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((4 0, 8 0, 8 4, 4 4, 4 0))";
  const ProgramRun features = oblast_program({"check", "-"}, two);
  EXPECT_EQ(features.code, 0);
  EXPECT_EQ(features.out, "valid: 2 features, 2 parts, 2 rings, 8 vertices\n");
  const ProgramRun coverage = oblast_program({"check", "-", "--coverage"}, two);
  EXPECT_EQ(coverage.code, 0);
  EXPECT_EQ(coverage.out, "valid coverage: 2 features, 2 parts, 2 rings, 8 vertices\n");
  // As one region set it is not valid, for the squares share an edge. As rows they fit together.
  EXPECT_EQ(oblast_program({"check", "-", "--regions"}, two).code, 1);
  EXPECT_EQ(oblast_program({"check", "-", "--rows"}, two).code, 0);
}

TEST(CheckFeatures, ListsTwentyAndCountsAll) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))\n";
  const ProgramRun run = oblast_program({"check", "-"}, text);
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.out, "30 faults in 30 features")) << run.out;
  EXPECT_TRUE(contains(run.out, "the first 20 of 30 faults:")) << run.out;
  EXPECT_TRUE(contains(run.out, "feature 19,") && !contains(run.out, "feature 20,")) << run.out;
  const ProgramRun json = oblast_program({"check", "-", "--json"}, text);
  EXPECT_EQ(Json::parse(json.out)["faults"].size(), 30u);
  EXPECT_EQ(Json::parse(json.out)["faults_by_kind"]["ring crosses itself"], 30);
}

TEST(CheckFeatures, WritesFaultsAsPoints) {
  const Folder folder;
  write_file(folder / "in.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))\nPOLYGON ((9 9, 9 9, 10 10, 9 10, 9 9))");
  for (const std::string extension : {".gpkg", ".geojson", ".shp", ".fgb", ".wkt"}) {
    const std::string out = folder.path("faults" + extension);
    const ProgramRun run = oblast_program({"check", folder.path("in.wkt"), "--faults", out});
    EXPECT_EQ(run.code, 1) << run.err;
    EXPECT_TRUE(contains(run.out, "wrote 2 points to " + out)) << run.out;
    // The check itself reads them.
    const ProgramRun points = oblast_program({"check", out});
    EXPECT_EQ(points.code, 1);
    EXPECT_EQ(points.out, out + " has no polygons, only 2 points; there is nothing to check\n");
    EXPECT_EQ(oblast_program({"check", folder.path("in.wkt"), "--faults", out}).code, 1) << "must not replace";
    EXPECT_TRUE(
        contains(oblast_program({"check", folder.path("in.wkt"), "--faults", out, "--overwrite"}).out, "wrote"));
  }
  const Json features = Json::parse(read_file(folder / "faults.geojson"))["features"];
  ASSERT_EQ(features.size(), 2u);
  EXPECT_EQ(features[0]["properties"]["kind"], "ring crosses itself");
  EXPECT_EQ(features[0]["properties"]["feature"], 0);
  EXPECT_EQ(features[0]["properties"]["ring"], 1);
  EXPECT_EQ(features[0]["properties"]["vertex"], 2);
  EXPECT_EQ(features[0]["properties"]["vertex_2"], 0);
  EXPECT_EQ(features[0]["geometry"]["coordinates"], Json({1.0, 1.0}));
  EXPECT_EQ(features[1]["properties"]["kind"], "repeated vertex");
  EXPECT_TRUE(features[1]["properties"]["feature_2"].is_null());
}

TEST(CheckFeatures, DrawsFaultsAtTheirPlaces) {
  const Folder folder;
  write_file(folder / "in.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))\nPOLYGON ((9 9, 9 9, 10 10, 9 10, 9 9))");
  const Words call{"check", folder.path("in.wkt"), "--svg", folder.path("p.svg")};
  const ProgramRun run = oblast_program(call);
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_TRUE(contains(run.out, "wrote the picture " + folder.path("p.svg"))) << run.out;
  const std::string svg = read_file(folder / "p.svg");
  EXPECT_TRUE(contains(svg, ">1 fault in in.wkt</text>")) << svg;
  EXPECT_TRUE(contains(svg, "ring crosses itself: 1</text>") && contains(svg, "repeated vertex: 1 (note)</text>"));
  // The fault is a tenth of the way from the lower left corner of the data to the upper right one, the note nine
  // tenths.
  const auto place = [&](const std::string& colour) {
    const auto end = svg.find("h0\" stroke=\"" + colour), begin = svg.rfind("\"M", end) + 2;
    return std::stod(svg.substr(begin, end - begin));
  };
  const double fault = place("#d55e00"), note = place("#888888");
  EXPECT_LT(fault, note);
  EXPECT_EQ(oblast_program(call).code, 1) << "must not replace";
  EXPECT_TRUE(contains(oblast_program(call).err, "exists already"));
  Words again = call;
  again.push_back("--overwrite");
  EXPECT_TRUE(contains(oblast_program(again).out, "wrote the picture"));
}

TEST(CheckFeatures, LinesAreNotPolygons) {
  for (const Words& more : {Words{}, Words{"--coverage"}, Words{"--regions"}, Words{"--rows"}}) {
    Words words{"check", "-"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun run = oblast_program(words, "LINESTRING (0 0, 1 1)\nLINESTRING (0 0, 1 1)\nPOINT (1 1)");
    EXPECT_EQ(run.code, 1);
    EXPECT_EQ(run.out, "standard input has no polygons, only 2 lines and 1 point; there is nothing to check\n");
  }
  const ProgramRun mixed = oblast_program({"check", "-"}, "LINESTRING (0 0, 1 1)\nPOLYGON ((0 0, 2 0, 2 2, 0 0))");
  EXPECT_EQ(mixed.code, 0);
  EXPECT_TRUE(contains(mixed.out, "not checked: 1 line\n")) << mixed.out;
}

TEST(CheckFeatures, RecordsOfShapefilesHaveNoRoles) {
  // Two shells, a hole in the second one and an island in it are one record. Its rings are valid, in any order.
  const Folder folder;
  write_file(folder / "in.wkt",
             "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((22 2, 23 2, 23 3, 22 2)), ((20 0, 29 0, 29 9, 20 9, 20 0), "
             "(21 1, 21 8, 28 8, 28 1, 21 1)))");
  ASSERT_EQ(oblast_program({"union", folder.path("in.wkt"), "-o", folder.path("out.shp")}).code, 0);
  EXPECT_EQ(oblast_program({"check", folder.path("out.shp")}).code, 0);
}

TEST(CheckFeatures, VerticesOfShapefilesHaveTheNumbersOfTheFile) {
  // More of it runs clockwise, as outer rings do in shapefiles, so it is written as it is. It is reversed on reading.
  const Folder folder;
  const std::vector<Point> points{{0, 0}, {4, 4}, {4, 0}, {0, 2}};
  const std::uint32_t ends[] = {4}, polygons[] = {1};
  io::write(folder.path("in.shp"), {points, ends, polygons});
  const ProgramRun run = oblast_program({"check", folder.path("in.shp"), "--json"});
  EXPECT_EQ(run.code, 1) << run.err;
  const Json fault = Json::parse(run.out)["faults"][0];
  EXPECT_EQ(fault["kind"], "ring crosses itself");
  // The edges from vertex 0 to 1 and from 2 to 3.
  EXPECT_EQ(fault["place"]["vertex"], 1);
  EXPECT_EQ(fault["other"]["vertex"], 3);
}

TEST(CheckFeatures, OptionsThatDoNotGoTogether) {
  const std::string square = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
  EXPECT_EQ(oblast_program({"check", "-", "--rows", "--coverage"}, square).code, 2);
  EXPECT_EQ(oblast_program({"check", "-", "--regions", "--coverage"}, square).code, 2);
  EXPECT_EQ(oblast_program({"check", "-", "--regions", "--faults", "x.wkt"}, square).code, 2);
  EXPECT_EQ(oblast_program({"check", "-", "--overwrite"}, square).code, 2);
  EXPECT_EQ(oblast_program({"check", "-", "--rows", "--svg", "x.svg"}, square).code, 2);
  EXPECT_EQ(oblast_program({"check", "-", "--svg", "-"}, square).code, 2);
  EXPECT_EQ(oblast_program({"check", "-", "--svg", "x.svg", "--faults", "x.svg"}, square).code, 2);
}

TEST(Check, TakesTheOptionsOfInputOfTheOtherCommands) {
  const Folder folder;
  const std::string path = folder.path("a.gpkg");
  ASSERT_EQ(oblast_program({"union", "-", "-o", path, "-q"}, "SRID=4326;POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))").code, 0);
  ASSERT_EQ(
      oblast_program({"union", "-", "-o", path + ":big", "-q"}, "SRID=4326;POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))").code,
      0);
  for (const Words& form : {Words{}, {"--coverage"}, {"--regions"}, {"--rows"}}) {
    const auto check = [&](const std::string& file, Words more) {
      Words words{"check", file};
      words.insert(words.end(), form.begin(), form.end());
      words.insert(words.end(), more.begin(), more.end());
      return oblast_program(words);
    };
    EXPECT_TRUE(contains(check(path, {}).err, "has 2 layers: a (polygons) and big (polygons)"));
    EXPECT_TRUE(contains(check(path + ":big", {}).out, "4 vertices"));
    EXPECT_TRUE(contains(check(path, {"--layer", "a", "--where", "polygon < 7"}).out, "4 vertices"));
    EXPECT_FALSE(contains(check(path, {"--layer", "a", "--where", "polygon > 7"}).out, "4 vertices"));
    const ProgramRun moved = check(path, {"--layer", "a", "--t_srs", "EPSG:3857"});
    EXPECT_EQ(moved.code, 0) << moved.err;
    EXPECT_TRUE(contains(moved.err, "note: input: transformed from WGS 84")) << moved.err;
  }
  const ProgramRun assumed =
      oblast_program({"check", "-", "--assume-crs", "EPSG:4326", "--faults", folder.path("f.gpkg")},
                     "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))");
  EXPECT_EQ(assumed.code, 1);
  EXPECT_TRUE(contains(assumed.err, "taken to be in WGS 84")) << assumed.err;
  EXPECT_EQ(oblast_program({"check", path, "--where", "polygon = 0", "--layer", "none"}).code, 1);
}

}  // namespace
}  // namespace oblast::test
