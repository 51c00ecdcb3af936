// Cases by topology, as text files in this folder: every subfolder is a topology, every file is a case.
//
// A case of two operands, NAME.wkt:
//
//   # one line about what it shows
//   A WKT
//   B WKT
//
// The test runs every operation, engine, convention and treatment of collinear vertices on it. All promises of a
// hostile case must hold (generators/trial.h), and the results are compared with exact recomputation.
//
// A case with known results, NAME.txt:
//
//   # one line about what it shows
//   fill RULE                      optional; for both operands
//   A WKT
//   B WKT
//   OPERATION [ogc|leonov-nikitin] [minimal]: WKT of the result     without a convention: for both
//
// Every engine must give these results, vertex by vertex. To detect mistakes in them, the exact checker must find them
// closed, canonical and right. Text that is not understood is an error that names file and line.
#include <gtest/gtest.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

#include "generators/trial.h"
#include "generators/wkt.h"
#include "verify/against.h"

namespace oblast::internal {
namespace {

namespace fs = std::filesystem;

struct Expectation {
  std::string line;
  Operation operation = Operation::unite;
  Options options;
  RegionSet result;
};

struct Case {
  std::optional<RegionSet> a, b;
  std::vector<Expectation> expectations;
};

FillRule rule_of(const std::string& name) {
  if (name == "polygons") return FillRule::polygons();
  if (name == "evenodd") return FillRule::even_odd();
  if (name == "nonzero") return FillRule::nonzero();
  if (name == "positive") return FillRule::positive();
  if (name == "negative") return FillRule::negative();
  const std::string counted = "atleast:";
  std::int32_t depth = 0;
  if (name.rfind(counted, 0) == 0) {
    const char* end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + counted.size(), end, depth);
    if (read.ec == std::errc() && read.ptr == end && depth >= 1) return FillRule::at_least(depth);
  }
  throw std::invalid_argument("unknown fill rule '" + name + "'");
}

Operation operation_of(const std::string& name) {
  if (name == "intersection") return Operation::intersection;
  if (name == "union") return Operation::unite;
  if (name == "difference") return Operation::difference;
  if (name == "symdifference") return Operation::symmetric_difference;
  throw std::invalid_argument("unknown operation '" + name + "'");
}

// "difference ogc minimal: WKT"; once for each convention it stands for.
void add_expectations(Case& c, const std::string& line, const FillRule& rule) {
  const auto colon = line.find(": ");
  if (colon == std::string::npos) throw std::invalid_argument("not understood: " + line);
  if (!c.a || !c.b) throw std::invalid_argument("a result before both operands");
  Expectation expectation;
  expectation.line = line;
  std::istringstream words(line.substr(0, colon));
  std::string word;
  words >> word;
  expectation.operation = operation_of(word);
  bool ogc = true, leonov_nikitin = true;
  while (words >> word) {
    if (word == "ogc") {
      leonov_nikitin = false;
    } else if (word == "leonov-nikitin") {
      ogc = false;
    } else if (word == "minimal") {
      expectation.options.collinear = CollinearVertices::drop;
    } else {
      throw std::invalid_argument("unknown word '" + word + "'");
    }
  }
  if (!ogc && !leonov_nikitin) throw std::invalid_argument("two conventions; leave both out");
  expectation.result = generators::soup_from_wkt(line.substr(colon + 2));
  expectation.options.fill_a = expectation.options.fill_b = rule;
  if (ogc) c.expectations.push_back(expectation);
  expectation.options.contours = ContourConvention::leonov_nikitin;
  if (leonov_nikitin) c.expectations.push_back(expectation);
}

void read_line(Case& c, FillRule& rule, const std::string& line, bool is_wkt) {
  const auto read_operand = [&](std::optional<RegionSet>& operand) {
    if (operand) throw std::invalid_argument("an operand given twice");
    operand = generators::soup_from_wkt(line.substr(2));
  };
  if (line.rfind("A ", 0) == 0) {
    read_operand(c.a);
  } else if (line.rfind("B ", 0) == 0) {
    read_operand(c.b);
  } else if (is_wkt) {
    throw std::invalid_argument("not understood, only 'A WKT' and 'B WKT' are: " + line);
  } else if (line.rfind("fill ", 0) == 0) {
    if (!c.expectations.empty()) throw std::invalid_argument("a fill rule after results, for which it would not hold");
    rule = rule_of(line.substr(5));
  } else {
    add_expectations(c, line, rule);
  }
}

// Throws std::runtime_error "NAME:LINE: what".
Case read_case(std::istream& file, const std::string& name, bool is_wkt) {
  Case c;
  FillRule rule;
  int number = 0;
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(name + ":" + std::to_string(number) + ": " + what);
  };
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    try {
      read_line(c, rule, line, is_wkt);
    } catch (const std::invalid_argument& e) {
      fail(e.what());
    }
  }
  if (!c.a || !c.b) fail("the file ends without both operands");
  if (!is_wkt && c.expectations.empty()) fail("the file ends without a result");
  return c;
}

Case read_case(const fs::path& path) {
  std::ifstream file(path);
  return read_case(file, path.string(), path.extension() == ".wkt");
}

/// Not the faults, which are for checks (tests/apps/check_test.cpp).
bool is_for_overlays(const fs::path& path) {
  return std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == "faults"; });
}

std::vector<fs::path> case_files(const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(OBLAST_SOURCE_DIR) / "tests" / "cases")) {
    if (entry.is_regular_file() && entry.path().extension() == extension && is_for_overlays(entry.path()))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(CaseFiles, allAreRead) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(OBLAST_SOURCE_DIR) / "tests" / "cases")) {
    if (!entry.is_regular_file() || !is_for_overlays(entry.path())) continue;
    const std::string extension = entry.path().extension().string();
    EXPECT_TRUE(extension == ".txt" || extension == ".wkt" || extension == ".cpp") << entry.path() << " is no case";
  }
}

std::string error_of(const std::string& text, bool is_wkt = false) {
  std::istringstream file(text);
  try {
    read_case(file, "case", is_wkt);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "none";
}

TEST(CaseFiles, whatIsNotUnderstoodIsAnErrorWithItsLine) {
  const std::string operands = "A POLYGON ((0 0, 1 0, 0 1, 0 0))\nB POLYGON EMPTY\n";
  const std::string result = ": POLYGON ((0 0, 1 0, 0 1, 0 0))\n";
  EXPECT_EQ(error_of(operands + "union" + result), "none");
  EXPECT_EQ(error_of(operands + "union ogc minimal" + result), "none");
  EXPECT_EQ(error_of(operands, true), "none");
  EXPECT_EQ(error_of(operands + "union minimall" + result), "case:3: unknown word 'minimall'");
  EXPECT_EQ(error_of(operands + "union ogc leonov-nikitin" + result), "case:3: two conventions; leave both out");
  EXPECT_EQ(error_of(operands + "unite" + result), "case:3: unknown operation 'unite'");
  EXPECT_EQ(error_of("fil evenodd\n" + operands + "union" + result), "case:1: not understood: fil evenodd");
  EXPECT_EQ(error_of("fill even_odd\n" + operands), "case:1: unknown fill rule 'even_odd'");
  EXPECT_EQ(error_of("fill atleast:2x\n" + operands), "case:1: unknown fill rule 'atleast:2x'");
  EXPECT_EQ(error_of(operands + "union" + result + "fill evenodd\n"),
            "case:4: a fill rule after results, for which it would not hold");
  EXPECT_EQ(error_of(operands + operands), "case:3: an operand given twice");
  EXPECT_EQ(error_of(operands), "case:2: the file ends without a result");
  EXPECT_EQ(error_of("A POLYGON EMPTY\n"), "case:1: the file ends without both operands");
  EXPECT_EQ(error_of(operands + "union" + result, true).substr(0, 23), "case:3: not understood,");
  EXPECT_EQ(error_of("A POLYGON EMPTY and more\n"), "case:1: expected nothing more at: and more");
}

class Cases : public testing::TestWithParam<fs::path> {};

TEST_P(Cases, comeOutAsWorkedOutByHand) {
  Case c = read_case(GetParam());
  for (Expectation& expected : c.expectations) {
    for (const Engine engine : {Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov}) {
      expected.options.engine = engine;
      const RegionSet result = overlay(*c.a, *c.b, expected.operation, expected.options);
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
    fault = verify::check_against(*c.a, *c.b, expected.operation, expected.options, expected.result, 1);
    EXPECT_FALSE(fault) << expected.line << ": " << fault->what;
  }
}

std::string test_name(const testing::TestParamInfo<fs::path>& tested) {
  std::string name = tested.param.parent_path().filename().string() + "_" + tested.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char ch) { return std::isalnum(ch) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Topology, Cases, testing::ValuesIn(case_files(".txt")), test_name);

class Operands : public testing::TestWithParam<fs::path> {};

TEST_P(Operands, keepEveryPromise) {
  const Case c = read_case(GetParam());
  generators::Request request;
  request.other_threads = request.other_engines = request.recompute = true;
  for (const ContourConvention contours : {ContourConvention::ogc, ContourConvention::leonov_nikitin}) {
    for (const CollinearVertices collinear : {CollinearVertices::keep, CollinearVertices::drop}) {
      for (const Operation chosen :
           {Operation::intersection, Operation::unite, Operation::difference, Operation::symmetric_difference}) {
        request.contours = contours;
        request.collinear = collinear;
        request.chosen = chosen;
        generators::Figures figures;
        const auto failure = generators::run_trial({*c.a, *c.b}, request, figures);
        EXPECT_FALSE(failure) << to_text(failure->broken) << ": " << failure->what << "\n" << to_text(request);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Topology, Operands, testing::ValuesIn(case_files(".wkt")), test_name);

}  // namespace
}  // namespace oblast::internal
