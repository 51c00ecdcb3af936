// `oblast generate`: generates data for measurements.
#include "oblast/generate.h"

#include <CLI/CLI.hpp>

namespace oblast::app {

void add_generate(CLI::App& program, Invocation& invocation) {
  CLI::App* generate = program.add_subcommand("generate", "Generate data for measurements.");
  generate->require_subcommand(1);
  generate->footer("`oblast help generate COMMAND` describes each.");
  add_generate_fires(*generate, invocation);
  add_generate_roads(*generate, invocation);
  add_generate_star(*generate, invocation);
}

}  // namespace oblast::app
