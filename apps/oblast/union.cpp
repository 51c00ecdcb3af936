// `oblast union`: unites all polygons of all files.
#include "oblast/job.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Each polygon of each file is filled by even-odd of its own rings. The result is the area
that at least one polygon covers. With `--fill atleast:3` it is the area that at least
three polygons cover. The rules evenodd, nonzero, positive and negative use the winding
number of all contours together.

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
  command->add_option("IN", arguments->inputs, "vector files or folders; `-`: WKT on standard input")
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
