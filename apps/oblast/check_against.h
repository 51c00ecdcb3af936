// `oblast check --against`: its options, and the check whether a file is the right result.
#pragma once

#include <oblast/options.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/layer.h"
#include "oblast/cli.h"
#include "oblast/inputs.h"

namespace oblast::app {

struct AgainstArguments {
  std::vector<std::string> operands;
  std::optional<Operation> operation;
  FillRule fill;
  std::optional<FillRule> fill_b;  ///< not given: the same as `fill`
  std::uint64_t points = 200'000;
  std::uint32_t lines = 1'000;
  std::uint64_t seed = 1;
  int threads = 0;
};

void add_against_options(CLI::App& command, AgainstArguments& arguments);

/// Throws CallError if the options contradict each other, or if standard input would be read twice.
void check_call(const std::string& file, const AgainstArguments& arguments);

/// The findings, as text and as an object for --json.
struct AgainstFindings {
  bool right = true;
  std::string text;
  nlohmann::ordered_json json;
};

/// Checks `result` with verify/oracle.h. REQUIRES: check_call has passed, and the result is closed. Throws io::IoError.
/// `input`: the coordinate systems that are assumed of the operands, and to which they are transformed.
AgainstFindings check_against(const io::Layer& result, const AgainstArguments& arguments, const InputArguments& input);

}  // namespace oblast::app
