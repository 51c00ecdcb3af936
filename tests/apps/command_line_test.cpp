// The program as a user runs it: help, results, reports, errors and exit codes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "apps/program_run.h"
#include "oblast/call_options.h"

namespace oblast::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* two_squares = "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((1 1, 3 1, 3 3, 1 3, 1 1)))\n";
constexpr const char* their_union = "POLYGON ((0 0, 2 0, 2 1, 3 1, 3 3, 1 3, 1 2, 0 2, 0 0))";

/// A polygon of 3,001 vertices, which is no small call.
std::string zigzag() {
  std::string text = "POLYGON ((0 0";
  for (int i = 1; i < 3000; ++i) text += fmt::format(", {} {}", i, i % 2 ? 1000 : 1);
  return text + ", 3000 0, 0 0))";
}

TEST(CommandLine, EveryCommandHasHelpWithAnExample) {
  for (const Words& command : {Words{"union"}, Words{"overlay"}, Words{"dissolve"}, Words{"depth"}, Words{"partition"},
                               Words{"buffer"}, Words{"check"}, Words{"corpus"}, Words{"generate", "fires"}}) {
    Words words = command;
    words.push_back("--help");
    const ProgramRun run = oblast_program(words);
    EXPECT_EQ(run.code, 0) << command.front();
    EXPECT_TRUE(contains(run.out, "Example")) << run.out;
    EXPECT_TRUE(contains(run.out, "oblast " + command.front())) << run.out;
    EXPECT_TRUE(contains(run.out, "--json")) << run.out;
    EXPECT_EQ(run.err, "");
  }
}

TEST(CommandLine, WithoutCommandShowsHelpAndFails) {
  const ProgramRun run = oblast_program({});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "overlay")) << run.err;
}

TEST(CommandLine, FaultsOfTheCallAreExitCodeTwoAndNameTheHelp) {
  const Folder folder;
  const std::string out = folder.path("out.wkt");
  const std::vector<std::pair<Words, std::string>> calls = {
      {{"unite"}, ""},
      {{"union", "-"}, "--output"},
      {{"union", "-o", out}, "IN"},
      {{"union", "-", "-o", out, "--fill", "atleast:0"}, "atleast:"},
      {{"union", "-", "-o", out, "--fill", "odd"}, "evenodd"},
      {{"union", "-", "-o", out, "--engine", "weiler"}, "leonov-nikitin"},
      {{"union", "-", "-o", out, "--threads", "-1"}, "--threads"},
      {{"union", "-", "-o", out, "--threads", "100000"}, "1024"},
      {{"union", "-", "-o", out, "--memory", "much"}, "4GiB"},
      {{"union", "-", "-o", out, "--memory", "4 gigabytes"}, "4GiB"},
      {{"union", "-", "-o", out, "--memory", "-1GiB"}, "4GiB"},
      {{"union", "-", "-o", out, "--memory", "0"}, "4GiB"},
      {{"overlay", "minus", "a.wkt", "b.wkt", "-o", out}, "symdifference"},
      {{"overlay", "union", "a.wkt", "-o", out}, "B"},
      {{"generate", "fires"}, "--output"},
      {{"generate", "fires", "-o", out, "--month", "august"}, "september"},
  };
  for (const auto& [words, said] : calls) {
    const ProgramRun run = oblast_program(words, two_squares);
    EXPECT_EQ(run.code, 2) << words.front();
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(contains(run.err, said)) << run.err;
    EXPECT_TRUE(contains(run.err, "--help")) << run.err;
  }
  EXPECT_TRUE(folder.names().empty());
}

// oneTBB prints a warning if it is asked for more threads than it may start.
TEST(CommandLine, MoreThreadsThanCoresAreNoReasonForAWarning) {
  const Folder folder;
  const std::string in = folder.path("in.wkt");
  write_file(in, zigzag());
  const ProgramRun run = oblast_program({"union", in, "-o", folder.path("out.wkt"), "-q", "--threads", "1024"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
}

TEST(CommandLine, ContradictionsAreExitCodeTwo) {
  EXPECT_EQ(oblast_program({"overlay", "union", "-", "-", "-o", "-"}, two_squares).code, 2);
  const ProgramRun format = oblast_program({"union", "-", "-o", "out.gpkg", "--format", "wkb"}, two_squares);
  EXPECT_EQ(format.code, 2);
  EXPECT_TRUE(contains(format.err, "--format is for `-o -`")) << format.err;
}

TEST(Memory, SizesAreReadInTheirUnits) {
  const std::pair<const char*, std::size_t> sizes[] = {
      {"1", 1},
      {"1B", 1},
      {"1000", 1000},
      {"2KiB", 2048},
      {"3MiB", 3u << 20},
      {"4GiB", std::size_t{4} << 30},
      {"1TiB", std::size_t{1} << 40},
      {"5KB", 5000},
      {"6MB", 6000000},
      {"7GB", 7000000000},
      {"1.5GiB", std::size_t{3} << 29},
      {"500 MB", 500000000},
      {"0.5KiB", 512},
  };
  for (const auto& [word, bytes] : sizes) EXPECT_EQ(app::parse_bytes(word), bytes) << word;
  for (const char* const word : {"", "GiB", "4Gib", "4GiBs", "1e3", "nan", "inf", "0", "0.5", "-4GiB", "99999999TiB"})
    EXPECT_THROW(app::parse_bytes(word), CLI::ValidationError) << word;
}

// Every command that computes ends with an error at the memory limit, and writes nothing.
TEST(Memory, ALimitThatIsTooSmallIsAnErrorThatSaysIt) {
  const Folder folder;
  const std::string in = folder.path("in.wkt"), out = folder.path("out.wkt");
  write_file(in, zigzag());
  const std::vector<Words> calls = {
      {"union", in, "-o", out},
      {"overlay", "union", in, in, "-o", out, "--merge"},
      {"overlay", "union", in, in, "-o", out},
      {"dissolve", in, "-o", out},
      {"depth", in, "-o", out},
      {"partition", in, in, "-o", out},
      {"buffer", in, "--distance", "1", "-o", out},
      {"triangulate", in, "-o", out},
      {"hull", in, "-o", out},
      {"classic", "weiler-atherton", "union", in, in, "-o", out},
      {"compare", in, in},
      {"layers", in},
  };
  for (Words words : calls) {
    words.insert(words.end(), {"--memory", "20B"});
    const ProgramRun run = oblast_program(words);
    EXPECT_EQ(run.code, 1) << words.front();
    EXPECT_TRUE(contains(run.err, "limit of 20 bytes")) << words.front() << ": " << run.err;
    EXPECT_EQ(run.out, "") << words.front();
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"in.wkt"});
}

TEST(Union, OfWktGoesFromStandardInputToStandardOutput) {
  const ProgramRun run = oblast_program({"union", "-", "-o", "-"}, two_squares);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "0 0, 2 0, 2 1, 3 1, 3 3, 1 3, 1 2, 0 2, 0 0")) << run.out;
  EXPECT_TRUE(contains(run.err, "1 polygon, 1 contour, 8 vertices")) << run.err;
  EXPECT_TRUE(contains(run.err, "2 intersections")) << run.err;
}

TEST(Union, QuietSaysNothing) {
  const ProgramRun run = oblast_program({"union", "-", "-o", "-", "-q"}, two_squares);
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
}

TEST(Union, FillRulesReachTheLibrary) {
  const auto result = [](const std::string& rule) {
    return oblast_program({"union", "-", "-o", "-", "-q", "--fill", rule}, two_squares).out;
  };
  EXPECT_TRUE(contains(result("atleast:2"), "1 1, 2 1, 2 2, 1 2, 1 1")) << result("atleast:2");
  EXPECT_TRUE(contains(result("negative"), "EMPTY")) << result("negative");
  EXPECT_EQ(result("nonzero"), result("polygons"));
  EXPECT_NE(result("evenodd"), result("polygons"));
}

TEST(Union, MinimalDropsCollinearVertices) {
  const std::string bar = "POLYGON ((0 0, 1 0, 2 0, 2 1, 0 1, 0 0))";
  EXPECT_TRUE(contains(oblast_program({"union", "-", "-o", "-", "-q"}, bar).out, "1 0,"));
  EXPECT_FALSE(contains(oblast_program({"union", "-", "-o", "-", "-q", "--minimal"}, bar).out, "1 0,"));
}

TEST(Union, JsonSaysWhatTheSummarySays) {
  const Folder folder;
  const ProgramRun run =
      oblast_program({"union", "-", "-o", folder.path("u.wkt"), "--json", "--svg", folder.path("u.svg")}, two_squares);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["command"], "union");
  EXPECT_EQ(json["engine"], "leonov-nikitin");
  EXPECT_EQ(json["operands"][0]["features"], 1);
  EXPECT_EQ(json["operands"][0]["contours"], 2);
  EXPECT_EQ(json["operands"][0]["vertices"], 8);
  EXPECT_EQ(json["result"]["polygons"], 1);
  EXPECT_EQ(json["result"]["vertices"], 8);
  EXPECT_EQ(json["result"]["area"], 7.0);
  EXPECT_EQ(json["intersections"], 2);
  EXPECT_GE(json["rounds"].get<int>(), 1);
  EXPECT_EQ(json["largest_displacement"], 0.0);
  EXPECT_GT(json["peak_memory_bytes"].get<long>(), 0);
  for (const char* stage :
       {"total", "read", "collect", "node", "label", "select", "link", "assemble", "write", "picture"}) {
    EXPECT_TRUE(json["seconds"].contains(stage)) << stage;
  }
  EXPECT_TRUE(contains(read_file(folder / "u.wkt"), "3 1, 3 3"));
  EXPECT_TRUE(contains(read_file(folder / "u.svg"), "<svg"));
}

TEST(Union, OfItsResultChangesNoByte) {
  const Folder folder;
  ASSERT_EQ(oblast_program({"union", "-", "-o", folder.path("u.wkt"), "-q"}, two_squares).code, 0);
  ASSERT_EQ(oblast_program({"union", folder.path("u.wkt"), "-o", folder.path("uu.wkt"), "-q"}).code, 0);
  EXPECT_EQ(read_file(folder / "u.wkt"), read_file(folder / "uu.wkt"));
}

TEST(Union, KeepsAnExistingFileUnlessTold) {
  const Folder folder;
  write_file(folder / "old.wkt", "kept");
  const ProgramRun refused = oblast_program({"union", "-", "-o", folder.path("old.wkt")}, two_squares);
  EXPECT_EQ(refused.code, 1);
  EXPECT_TRUE(contains(refused.err, "--overwrite")) << refused.err;
  EXPECT_EQ(read_file(folder / "old.wkt"), "kept");
  EXPECT_EQ(oblast_program({"union", "-", "-o", folder.path("old.wkt"), "--overwrite"}, two_squares).code, 0);
  EXPECT_TRUE(contains(read_file(folder / "old.wkt"), "POLYGON"));
}

TEST(Union, FaultyDataIsExitCodeOneAndLeavesNoFile) {
  const Folder folder;
  write_file(folder / "text.shp", "no shapefile");
  const std::vector<std::pair<Words, std::string>> calls = {
      {{"union", folder.path("text.shp")}, "text.shp"},
      {{"union", "-"}, "vertex 1"},
  };
  for (const auto& [words, said] : calls) {
    Words all = words;
    all.insert(all.end(), {"-o", folder.path("out.gpkg"), "--svg", folder.path("out.svg")});
    const ProgramRun run = oblast_program(all, "POLYGON ((0 0, nan 1, 1 1, 0 0))");
    EXPECT_EQ(run.code, 1);
    EXPECT_TRUE(contains(run.err, said)) << run.err;
  }
  EXPECT_EQ(folder.names(), Words{"text.shp"});
}

TEST(Union, UnwritableOutputIsToldBeforeTheWork) {
  const Folder folder;
  EXPECT_EQ(oblast_program({"union", "-", "-o", folder.path("none/out.gpkg")}, two_squares).code, 1);
  EXPECT_EQ(oblast_program({"union", "-", "-o", folder.path("out.docx")}, two_squares).code, 1);
  EXPECT_EQ(
      oblast_program({"union", "-", "-o", folder.path("o.wkt"), "--svg", folder.path("none/p.svg")}, two_squares).code,
      1);
  EXPECT_TRUE(folder.names().empty());
}

TEST(Union, ErrorsComeAsJsonToo) {
  const ProgramRun run = oblast_program({"union", "no-such-file.gpkg", "-o", "x.wkt", "--json"});
  EXPECT_EQ(run.code, 2);
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["exit_code"], 2);
  EXPECT_TRUE(contains(json["error"], "no-such-file.gpkg"));
}

TEST(Union, StrictRefusesLines) {
  const Folder folder;
  write_file(folder / "mixed.geojson", R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}},
    {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}}]})");
  const ProgramRun lenient = oblast_program({"union", folder.path("mixed.geojson"), "-o", "-"});
  EXPECT_EQ(lenient.code, 0) << lenient.err;
  EXPECT_TRUE(contains(lenient.err, "1 line feature passed over")) << lenient.err;
  EXPECT_EQ(oblast_program({"union", folder.path("mixed.geojson"), "-o", "-", "--strict"}).code, 1);
}

TEST(Overlay, OperationsFollowTheirNames) {
  const Folder folder;
  write_file(folder / "a.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  write_file(folder / "b.wkt", "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))");
  const std::vector<std::pair<std::string, double>> areas = {
      {"intersection", 1}, {"union", 7}, {"difference", 3}, {"symdifference", 6}};
  for (const auto& [operation, area] : areas) {
    for (const char* engine : {"leonov-nikitin", "vatti", "skvortsov"}) {
      const ProgramRun run =
          oblast_program({"overlay", operation, folder.path("a.wkt"), folder.path("b.wkt"), "-o", folder.path("r.wkt"),
                          "--merge", "--overwrite", "--json", "--engine", engine});
      ASSERT_EQ(run.code, 0) << run.err;
      EXPECT_EQ(Json::parse(run.out)["result"]["area"], area) << operation;
    }
  }
}

TEST(Overlay, TwoCoordinateSystemsAreAnError) {
  const Folder folder;
  const std::string square =
      R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}}]})";
  write_file(folder / "a.geojson", R"({"type":"FeatureCollection",)" + square);
  write_file(
      folder / "b.geojson",
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3857"}},)" +
          square);
  const ProgramRun run = oblast_program(
      {"overlay", "union", folder.path("a.geojson"), folder.path("b.geojson"), "-o", folder.path("o.gpkg")});
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.err, "two coordinate systems")) << run.err;
  EXPECT_TRUE(contains(run.err, "b.geojson")) << run.err;
}

TEST(Overlay, SecondFillRuleIsForTheSecondOperand) {
  const Folder folder;
  write_file(folder / "a.wkt", two_squares);
  write_file(folder / "b.wkt", two_squares);
  const ProgramRun run =
      oblast_program({"overlay", "difference", folder.path("a.wkt"), folder.path("b.wkt"), "-o", folder.path("o.wkt"),
                      "--merge", "--fill-b", "atleast:2", "--fill", "polygons", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["result"]["area"], 6.0);
}

TEST(Check, NamesTheFirstFaultAndItsPlace) {
  const ProgramRun crossing = oblast_program({"check", "-", "--regions"}, "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))");
  EXPECT_EQ(crossing.code, 1);
  EXPECT_TRUE(contains(crossing.out, "not a valid region set")) << crossing.out;
  EXPECT_TRUE(contains(crossing.out, "vertex")) << crossing.out;
  const ProgramRun good = oblast_program({"check", "-", "--regions"}, std::string(their_union));
  EXPECT_EQ(good.code, 0) << good.out;
  EXPECT_TRUE(contains(good.out, "1 polygon, 1 contour, 8 vertices")) << good.out;
}

TEST(Check, OrderCountsOnlyWhenAskedFor) {
  const std::string rotated = "POLYGON ((2 0, 2 2, 0 2, 0 0, 2 0))";
  EXPECT_EQ(oblast_program({"check", "-", "--regions"}, rotated).code, 0);
  const ProgramRun run = oblast_program({"check", "-", "--canonical", "--json"}, rotated);
  EXPECT_EQ(run.code, 1);
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["valid"], true);
  EXPECT_EQ(json["canonical"], false);
  EXPECT_TRUE(json["fault"].contains("what"));
}

TEST(CheckAgainst, ProvesAnOverlayOrNamesTheWrongPlace) {
  const Folder folder;
  write_file(folder / "a.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  write_file(folder / "b.wkt", "POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))");
  const Words against{"--against", folder.path("a.wkt"), folder.path("b.wkt"), "--points", "1000", "--lines", "20"};
  const auto check = [&](const std::string& result, const Words& more) {
    Words words{"check", "-"};
    words.insert(words.end(), against.begin(), against.end());
    words.insert(words.end(), more.begin(), more.end());
    return oblast_program(words, result);
  };
  const std::string both = "POLYGON ((2 2, 4 2, 4 4, 2 4, 2 2))",
                    only_a = "POLYGON ((0 0, 4 0, 4 2, 2 2, 2 4, 0 4, 0 0))";
  const ProgramRun right = check(both, {"--op", "intersection"});
  EXPECT_EQ(right.code, 0) << right.out << right.err;
  EXPECT_TRUE(contains(right.out, "right: no wrong place")) << right.out;
  EXPECT_TRUE(contains(right.out, "area: 4,")) << right.out;

  const ProgramRun wrong = check(only_a, {"--op", "intersection"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_TRUE(contains(wrong.out, "wrong: at (")) << wrong.out;
  const ProgramRun json = check(only_a, {"--op", "intersection", "--json"});
  EXPECT_EQ(json.code, 1);
  EXPECT_EQ(Json::parse(json.out)["valid"], true);
  EXPECT_EQ(Json::parse(json.out)["against"]["right"], false);
  EXPECT_TRUE(Json::parse(json.out)["against"]["wrong"].contains("at"));

  // Fill rules of each operand, and of one operand made of both files.
  EXPECT_EQ(check(only_a, {"--op", "difference"}).code, 0);
  EXPECT_EQ(check("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", {"--op", "difference", "--fill-b", "atleast:2"}).code, 0);
  EXPECT_EQ(check(both, {"--fill", "atleast:2"}).code, 0);
  EXPECT_EQ(check(both, {"--fill", "atleast:3"}).code, 1);
}

TEST(CheckAgainst, RefusesWhatItCannotAnswer) {
  const Folder folder;
  write_file(folder / "a.wkt", two_squares);
  EXPECT_EQ(oblast_program({"check", "-", "--against", folder.path("a.wkt"), "--op", "difference"}, two_squares).code,
            2);
  EXPECT_EQ(oblast_program({"check", "-", "--op", "union"}, two_squares).code, 2);
  EXPECT_EQ(oblast_program({"check", "-", "--against", "-"}, two_squares).code, 2);
  EXPECT_EQ(oblast_program({"check", "-", "--against", folder.path("a.wkt"), "--fill-b", "evenodd"}, two_squares).code,
            2);
  EXPECT_EQ(oblast_program({"check", "-", "--against", folder.path("a.wkt"), "--op", "clip"}, two_squares).code, 2);
  write_file(folder / "huge.wkt", "POLYGON ((0 0, 1e200 0, 0 1, 0 0))");
  const ProgramRun huge =
      oblast_program({"check", "-", "--against", folder.path("huge.wkt")}, std::string(their_union));
  EXPECT_EQ(huge.code, 1);
  EXPECT_TRUE(contains(huge.err, "outside the domain")) << huge.err;
}

TEST(Interrupt, LeavesTheOldOutputAlone) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the thread sanitizer holds a signal back while the program waits for input";
#endif
  const Folder folder;
  write_file(folder / "old.wkt", "kept");
  std::string much;
  while (much.size() < 300'000)
    much += two_squares;  // more than the capacity of a pipe, so the program is still reading
  const ProgramRun run = interrupted_program({"union", "-", "-o", folder.path("old.wkt"), "--overwrite"}, much);
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_TRUE(contains(run.err, "interrupted")) << run.err;
  EXPECT_EQ(read_file(folder / "old.wkt"), "kept");
  EXPECT_EQ(folder.names(), Words{"old.wkt"});
}

}  // namespace
}  // namespace oblast::test
