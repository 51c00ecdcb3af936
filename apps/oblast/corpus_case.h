// One case of a corpus: a line of cases.jsonl, and the conditions it must meet.
#pragma once

#include <oblast/options.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace oblast::app {

struct CorpusCase {
  std::string id;
  std::string source;
  Operation operation = Operation::unite;
  /// Operands as WKT: one (its union is computed), two, or more, which are combined from left to right.
  std::vector<std::string> operands;
  FillRule fill;
  double area = 0;                ///< the expected area of the result
  std::string area_from;          ///< "ref.exact_area", "ref.area" or "expect.area"
  double relative_tolerance = 0;  ///< relative to the area of the input
};

/// Reads one line of cases.jsonl. Throws a std::exception whose message says what is wrong with the line.
CorpusCase parse_case(const std::string& line);

/// Computes the case by every engine and checks that the result verifies (G2, G3), that uniting it changes no byte,
/// that the engines give the same bytes, and that the area is right. Returns the first failure, or nothing.
std::optional<std::string> run_case(const CorpusCase& corpus_case);

}  // namespace oblast::app
