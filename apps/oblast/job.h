// The common part of `union` and `overlay --merge`: their options, and the work from input files to the summary.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <optional>
#include <string>
#include <vector>

#include "io/layer.h"
#include "oblast/cli.h"
#include "oblast/command.h"
#include "oblast/inputs.h"
#include "oblast/outputs.h"

namespace oblast::app {

/// Options as given on the command line. Commands whose results are rows have some of them.
struct JobArguments {
  InputArguments input;
  OutputArguments output;
  std::string picture;
  bool strict = false;
  bool quiet = false;
  bool minimal = false;
  FillRule fill;
  std::optional<FillRule> fill_b;  ///< not given: the same as `fill`
  Options options;                 ///< engine, contours, threads
};

/// The options of the files and of the computation that every command with a result has.
void add_file_options(CLI::App& command, JobArguments& arguments, Invocation& invocation);

/// The same for zones of shapes: their lines and points count, and their contours are as the library makes them.
void add_zone_file_options(CLI::App& command, JobArguments& arguments, Invocation& invocation);
/// Adds all options to a command. Only a command with two operands gets `--fill-b`.
enum class Operands { one, two };
void add_job_options(CLI::App& command, JobArguments& arguments, Invocation& invocation, Operands operands);

/// Checks that options do not contradict each other. Throws CallError.
void check_call(const std::vector<std::vector<std::string>>& operands, const JobArguments& arguments, bool json);

/// Throws CallError if the picture cannot be where the other output is.
void check_picture_call(const std::string& picture, const std::string& output, bool json);
/// What --svg does, for help.
inline constexpr const char* picture_option =
    "also draw the operands and the result: a name in .svg or .png, or `-` for SVG on standard output";

/// The inputs and the operation of a job.
struct Job {
  std::string command;                             ///< "union" or "overlay difference", for the summary
  std::vector<std::vector<std::string>> operands;  ///< one or two lists of paths
  Operation operation = Operation::unite;
};

/// Reads, computes, writes, draws and reports. Returns an exit code.
int run_job(const Job& job, const JobArguments& arguments, bool json);

}  // namespace oblast::app
