// What `union` and `overlay` share: their options, and the way from input files to the summary.
#pragma once

#include <oblast/options.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oblast/command.h"

namespace oblast::app {

/// Options common to both commands, as given on the command line.
struct JobArguments {
  std::string output;
  std::string picture;
  bool overwrite = false;
  bool strict = false;
  bool quiet = false;
  bool minimal = false;
  FillRule fill;
  std::optional<FillRule> fill_b;  ///< as `fill` where not given
  Options options;                 ///< engine, contours, threads
};

/// Adds the common options to a command. `--fill-b` only where there is a second operand.
enum class Operands { one, two };
void add_job_options(CLI::App& command, JobArguments& arguments, Invocation& invocation, Operands operands);

/// One job: what to read, what to compute.
struct Job {
  std::string command;                             ///< "union" or "overlay difference", for the summary
  std::vector<std::vector<std::string>> operands;  ///< one or two lists of paths
  Operation operation = Operation::unite;
};

/// Reads, computes, writes, draws and reports. Returns an exit code.
int run_job(const Job& job, const JobArguments& arguments, bool json);

}  // namespace oblast::app
