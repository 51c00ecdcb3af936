// Cases by topology, as text files beside this one: every folder is a topology, every file a case.
//
//   # what it shows, one line
//   fill RULE                      optional; of both operands
//   A WKT
//   B WKT
//   OPERATION [ogc|leonov-nikitin] [minimal]: WKT of the result     without a convention: the same by both
//
// Results were worked out by hand. They must come out vertex by vertex, by every engine; and, lest the hand be wrong,
// the exact checker must find them closed, canonical and right.
#include <gtest/gtest.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "generators/wkt.h"
#include "verify/against.h"

namespace oblast {
namespace {

namespace fs = std::filesystem;

struct Expectation {
  std::string line;
  Operation operation = Operation::unite;
  Options options;
  RegionSet result;
};

struct Case {
  RegionSet a, b;
  std::vector<Expectation> expectations;
};

FillRule rule_of(const std::string& name) {
  if (name == "polygons") return FillRule::polygons();
  if (name == "evenodd") return FillRule::even_odd();
  if (name == "nonzero") return FillRule::nonzero();
  if (name == "positive") return FillRule::positive();
  if (name == "negative") return FillRule::negative();
  if (name.rfind("atleast:", 0) == 0) return FillRule::at_least(std::stoi(name.substr(8)));
  throw std::invalid_argument("unknown fill rule " + name);
}

Operation operation_of(const std::string& name) {
  if (name == "intersection") return Operation::intersection;
  if (name == "union") return Operation::unite;
  if (name == "difference") return Operation::difference;
  if (name == "symdifference") return Operation::symmetric_difference;
  throw std::invalid_argument("unknown operation " + name);
}

// "difference ogc minimal: WKT"; once for each convention it stands for.
void add_expectations(Case& c, const std::string& line, const FillRule& rule) {
  const auto colon = line.find(": ");
  if (colon == std::string::npos) throw std::invalid_argument("not understood: " + line);
  Expectation expectation;
  expectation.line = line;
  expectation.result = generators::soup_from_wkt(line.substr(colon + 2));
  expectation.options.fill_a = expectation.options.fill_b = rule;
  std::istringstream words(line.substr(0, colon));
  std::string word;
  words >> word;
  expectation.operation = operation_of(word);
  bool ogc = true, leonov_nikitin = true;
  while (words >> word) {
    if (word == "ogc") leonov_nikitin = false;
    if (word == "leonov-nikitin") ogc = false;
    if (word == "minimal") expectation.options.collinear = CollinearVertices::drop;
  }
  if (ogc) c.expectations.push_back(expectation);
  expectation.options.contours = ContourConvention::leonov_nikitin;
  if (leonov_nikitin) c.expectations.push_back(expectation);
}

Case read_case(const fs::path& path) {
  Case c;
  FillRule rule;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line.rfind("fill ", 0) == 0) {
      rule = rule_of(line.substr(5));
    } else if (line.rfind("A ", 0) == 0) {
      c.a = generators::soup_from_wkt(line.substr(2));
    } else if (line.rfind("B ", 0) == 0) {
      c.b = generators::soup_from_wkt(line.substr(2));
    } else {
      add_expectations(c, line, rule);
    }
  }
  return c;
}

std::vector<fs::path> case_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(OBLAST_SOURCE_DIR) / "tests" / "cases")) {
    if (entry.path().extension() == ".txt" && entry.path().filename() != "CMakeLists.txt")
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class Cases : public testing::TestWithParam<fs::path> {};

TEST_P(Cases, comeOutAsWorkedOutByHand) {
  Case c = read_case(GetParam());
  ASSERT_FALSE(c.expectations.empty());
  for (Expectation& expected : c.expectations) {
    for (const Engine engine : {Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov}) {
      expected.options.engine = engine;
      const RegionSet result = overlay(c.a, c.b, expected.operation, expected.options);
      EXPECT_EQ(generators::soup_to_wkt(result), generators::soup_to_wkt(expected.result))
          << expected.line << ", engine " << static_cast<int>(engine);
    }
  }
}

TEST_P(Cases, areRightAsWritten) {
  const Case c = read_case(GetParam());
  for (const Expectation& expected : c.expectations) {
    auto fault = verify::check_result(expected.result, expected.options.contours);
    EXPECT_FALSE(fault) << expected.line << ": " << fault->what;
    fault = verify::check_against(c.a, c.b, expected.operation, expected.options, expected.result, 1);
    EXPECT_FALSE(fault) << expected.line << ": " << fault->what;
  }
}

std::string test_name(const testing::TestParamInfo<fs::path>& tested) {
  std::string name = tested.param.parent_path().filename().string() + "_" + tested.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char ch) { return std::isalnum(ch) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Topology, Cases, testing::ValuesIn(case_files()), test_name);

}  // namespace
}  // namespace oblast
