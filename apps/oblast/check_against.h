// `oblast check --against`: the options, and the question whether a file is the right answer.
#pragma once

#include <oblast/options.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/layer.h"

namespace oblast::app {

struct AgainstArguments {
  std::vector<std::string> operands;
  std::optional<Operation> operation;
  FillRule fill;
  std::optional<FillRule> fill_b;  ///< as `fill` where not given
  std::uint64_t points = 200'000;
  std::uint32_t lines = 1'000;
  std::uint64_t seed = 1;
  int threads = 0;
};

void add_against_options(CLI::App& command, AgainstArguments& arguments);

/// Throws CallError where the options contradict each other, or standard input would be read twice.
void check_call(const std::string& file, const AgainstArguments& arguments);

/// What was found, as words and as an object for --json.
struct AgainstFindings {
  bool right = true;
  std::string text;
  nlohmann::ordered_json json;
};

/// Judges `result` (closed) by verify/oracle.h. REQUIRES: check_call. Throws io::IoError.
AgainstFindings check_against(const io::Layer& result, const AgainstArguments& arguments);

}  // namespace oblast::app
