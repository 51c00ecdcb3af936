// `oblast corpus`: the meaning of a line, and that it detects a wrong expectation.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/program_run.h"
#include "oblast/corpus_case.h"

namespace oblast::test {
namespace {

constexpr const char* square = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))";
constexpr const char* shifted = "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))";

std::string line(const std::string& op, const std::string& a, const nlohmann::json& b, double area) {
  return nlohmann::json{
      {"id", "s/" + op}, {"op", op}, {"a", a}, {"b", b}, {"ref", {{"exact_area", area}, {"area", 99}}}}
      .dump();
}

TEST(CorpusCase, TakesTheExactAreaFirst) {
  const app::CorpusCase corpus_case = app::parse_case(line("union", square, nullptr, 4));
  EXPECT_EQ(corpus_case.area, 4);
  EXPECT_EQ(corpus_case.area_from, "ref.exact_area");
  EXPECT_EQ(corpus_case.relative_tolerance, 1e-9);
  EXPECT_EQ(corpus_case.fill, FillRule::polygons());
}

TEST(CorpusCase, FallsBackToTheSourceAndItsTolerance) {
  const auto parse = [](const std::string& note) {
    return app::parse_case(nlohmann::json{
        {"id", "x"},
        {"op", "union"},
        {"a", square},
        {"b", nullptr},
        {"fill", "evenodd"},
        {"expect", {{"area", 5}}},
        {"ref", {{"exact_area", nullptr}, {"area", nullptr}}},
        {"note", note}}.dump());
  };
  EXPECT_EQ(parse("").area_from, "expect.area");
  EXPECT_EQ(parse("").relative_tolerance, 1e-9);
  EXPECT_EQ(parse("").fill, FillRule::even_odd());
  EXPECT_EQ(parse("file=3; area_tol_frac=0.25").relative_tolerance, 0.25);
  EXPECT_DOUBLE_EQ(parse("source tolerance 0.001%").relative_tolerance, 1e-5);
}

TEST(CorpusCase, AllOperationsPassWithTheRightArea) {
  EXPECT_EQ(app::run_case(app::parse_case(line("union", square, shifted, 7))), std::nullopt);
  EXPECT_EQ(app::run_case(app::parse_case(line("intersection", square, shifted, 1))), std::nullopt);
  EXPECT_EQ(app::run_case(app::parse_case(line("difference", square, shifted, 3))), std::nullopt);
  EXPECT_EQ(app::run_case(app::parse_case(line("xor", square, shifted, 6))), std::nullopt);
}

TEST(CorpusCase, AWrongAreaFails) {
  const auto failure = app::run_case(app::parse_case(line("union", square, shifted, 7.001)));
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("ref.exact_area"), std::string::npos) << *failure;
}

TEST(CorpusCase, ACollectionIsFoldedOverItsMembers) {
  const std::string three =
      std::string("GEOMETRYCOLLECTION (") + square +
      ", MULTIPOLYGON (((1 1, 3 1, 3 3, 1 3, 1 1))), POLYGON ((0 0, 1.5 0, 1.5 1.5, 0 1.5, 0 0)))";
  EXPECT_EQ(app::parse_case(line("xor", three, nullptr, 0)).operands.size(), 3u);
  EXPECT_EQ(app::run_case(app::parse_case(line("intersection", three, nullptr, 0.25))), std::nullopt);
  EXPECT_EQ(app::run_case(app::parse_case(line("xor", three, nullptr, 6 + 2.25 - 2 * 2))), std::nullopt);
}

TEST(CorpusCommand, CountsExcusesAndFilters) {
  const Folder folder;
  write_file(folder / "cases.jsonl", line("union", square, shifted, 7) + "\n" + line("difference", square, shifted, 2) +
                                         "\n" + line("xor", square, shifted, 5) + "\n");
  write_file(folder / "excused.txt", "# why\ns/xor\tthe source counts otherwise\n");
  const ProgramRun run = oblast_program({"corpus", folder.path(""), "--excuse", folder.path("excused.txt")});
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("\n1 passed, 1 failed\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("failed   s/difference"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("excused  s/xor: the source counts otherwise"), std::string::npos) << run.out;
  const ProgramRun filtered = oblast_program({"corpus", folder.path(""), "--filter", "s/union"});
  EXPECT_EQ(filtered.code, 0);
  EXPECT_EQ(filtered.out, "1 passed, 0 failed\n");
  const auto json = nlohmann::json::parse(oblast_program({"corpus", folder.path(""), "--json"}).out);
  EXPECT_EQ(json["passed"], 1);
  EXPECT_EQ(json["failed"], 2);
  EXPECT_EQ(json["failures"][0]["id"], "s/difference");
}

TEST(CorpusCommand, UnreadableLinesFail) {
  const Folder folder;
  write_file(folder / "cases.jsonl", "{\"id\": \"x\"}\n");
  const ProgramRun run = oblast_program({"corpus", folder.path("")});
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("0 passed, 1 failed"), std::string::npos) << run.out;
  EXPECT_EQ(oblast_program({"corpus", folder.path("none")}).code, 1);
}

}  // namespace
}  // namespace oblast::test
