// One case of a corpus: a line of cases.jsonl, and what must hold for it.
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
  /// Operands as WKT: one (the union of itself), two, or more to be folded from the left.
  std::vector<std::string> operands;
  FillRule fill;
  double area = 0;                ///< what the result's area must be
  std::string area_from;          ///< "ref.exact_area", "ref.area" or "expect.area"
  double relative_tolerance = 0;  ///< of the input's area
};

/// From one line of cases.jsonl. Throws std::runtime_error that says what is wrong with the line.
CorpusCase parse_case(const std::string& line);

/// Computes the case by every engine and returns the first thing that does not hold:
/// the result verifies (G2, G3), uniting it changes no byte, the engines agree to the byte, the area
/// agrees. Nothing when all of it holds.
std::optional<std::string> run_case(const CorpusCase& corpus_case);

}  // namespace oblast::app
