// `oblast union`: all contours of all files to one region set.
#include "oblast/job.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Every polygon of every file counts as the even-odd of its own rings, and the result
is everything at least one polygon covers. `--fill atleast:3` gives what at least
three polygons cover.

Example: one clean layer from a folder of shapefiles, with a picture
  oblast union fires/ -o burnt.gpkg --svg burnt.svg)";

}  // namespace

void add_union(CLI::App& program, Invocation& invocation) {
  struct Arguments {
    std::vector<std::string> inputs;
    JobArguments job;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("union", "Unite all polygons of all files in one pass.");
  command->footer(footer);
  command->add_option("IN", arguments->inputs, "vector files, folders of them, `-` for WKT on standard input")
      ->required()
      ->type_name("");
  add_job_options(*command, arguments->job, invocation, Operands::one);
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] {
      const Job job{"union", {arguments->inputs}, Operation::unite};
      return run_job(job, arguments->job, invocation.json);
    };
  });
}

}  // namespace oblast::app
