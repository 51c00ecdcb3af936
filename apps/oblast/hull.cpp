// `oblast hull`: the convex hull of all contours in files or folders.
#include <fmt/format.h>
#include <oblast/hull.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "io/read.h"
#include "io/row_measures.h"
#include "io/write.h"
#include "oblast/call_options.h"
#include "oblast/command.h"
#include "oblast/console.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Lee's scan computes the hull of each contour, in linear time if the contour is simple.
Then the hull of these hulls is computed. Its corners are vertices of the input, bit for
bit.

Example
  oblast hull burnt.gpkg -o hull.gpkg)";

struct Arguments {
  std::vector<std::string> inputs;
  std::string output;
  bool overwrite = false, quiet = false;
  CallOptions options;
};

int run(const Arguments& arguments, bool json) {
  if (json && arguments.output == "-")
    throw CallError("--json and `-o -` both write to standard output; leave one of them out");
  io::WriteOptions options;
  options.existing = arguments.overwrite ? io::Existing::overwrite : io::Existing::refuse;
  io::check_writable(arguments.output, options);
  const io::Layer layer = io::read(arguments.inputs);
  RegionSet result;
  try {
    result = hull(RegionView(layer.regions), arguments.options);
  } catch (const Error& error) {
    if (error.place().contour == Place::npos) throw;
    throw io::IoError(fmt::format("{}: {}", io::describe(layer, error.place()), error.what()));
  }
  options.crs_wkt = layer.crs_wkt;
  io::write(arguments.output, result, options);
  if (json) {
    const nlohmann::ordered_json object{{"command", "hull"},
                                        {"output", arguments.output},
                                        {"input_vertices", layer.regions.points.size()},
                                        {"vertices", result.points.size()},
                                        {"area", signed_area(result)}};
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!arguments.quiet) {
    fmt::print(stderr, "hull of {} in {}: {}, area {}\n", counted(layer.regions.points.size(), "vertex"),
               counted(layer.regions.contour_ends.size(), "contour"), counted(result.points.size(), "corner"),
               io::RowMeasures(layer.crs_wkt).area_text(result));
  }
  return exit_done;
}

}  // namespace

void add_hull(CLI::App& program, Invocation& invocation) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("hull", "The convex hull of all contours.");
  command->footer(footer);
  command->add_option("IN", a->inputs, "vector files or folders; `-`: WKT on standard input")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", a->output, "file for the hull; `-`: WKT on standard output")
      ->required()
      ->type_name("OUT");
  add_call_options(*command, a->options);
  command->add_flag("--overwrite", a->overwrite, "replace an existing file");
  command->add_flag("--json", invocation.json, "print the summary as one JSON object on standard output");
  command->add_flag("-q,--quiet", a->quiet, "print no summary");
  command->callback([a, &invocation] { invocation.run = [a, &invocation] { return run(*a, invocation.json); }; });
}

}  // namespace oblast::app
