// The options of `oblast buffer`.
#pragma once

#include <oblast/buffer.h>

#include <string>
#include <vector>

#include "oblast/cli.h"
#include "oblast/row_job.h"

namespace oblast::app {

/// As given on the command line.
struct BufferArguments {
  std::vector<std::string> inputs;
  std::string distance, tolerance = "1%", crs;
  bool by_feature = false;
  bool mitre_limit_given = false;
  BufferOptions options;
  JobArguments job;
  RowArguments rows;
};

/// Adds the command with its options and its help.
CLI::App* add_buffer_options(CLI::App& program, BufferArguments& arguments, Invocation& invocation);

}  // namespace oblast::app
