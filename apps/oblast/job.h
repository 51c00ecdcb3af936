// The common part of `union` and `overlay`: their options, and the work from input files to the summary.
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
  std::optional<FillRule> fill_b;  ///< not given: the same as `fill`
  Options options;                 ///< engine, contours, threads
};

/// Adds the common options to a command. Only a command with two operands gets `--fill-b`.
enum class Operands { one, two };
void add_job_options(CLI::App& command, JobArguments& arguments, Invocation& invocation, Operands operands);

/// The inputs and the operation of a job.
struct Job {
  std::string command;                             ///< "union" or "overlay difference", for the summary
  std::vector<std::vector<std::string>> operands;  ///< one or two lists of paths
  Operation operation = Operation::unite;
};

/// Reads, computes, writes, draws and reports. Returns an exit code.
int run_job(const Job& job, const JobArguments& arguments, bool json);

}  // namespace oblast::app
