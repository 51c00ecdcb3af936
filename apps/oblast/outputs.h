// What the commands that write a result have in common: where it goes, and where the report goes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "io/write.h"
#include "oblast/cli.h"
#include "oblast/command.h"

namespace oblast::app {

/// Options as given on the command line.
struct OutputArguments {
  std::string output;
  std::optional<io::TextFormat> format;
  bool overwrite = false;
};

/// Adds -o, --format and --overwrite.
void add_output_options(CLI::App& command, OutputArguments& arguments, Invocation& invocation);

/// Checks that the options do not contradict each other. Throws CallError.
io::WriteOptions write_options(const OutputArguments& arguments);

/// The report, as one JSON object: on standard output, or on standard error if the result goes to standard output.
void print_json(const nlohmann::ordered_json& report, const std::string& output);

}  // namespace oblast::app
