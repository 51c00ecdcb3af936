// `oblast hull`: the convex hull of all contours in files or folders.
#include <fmt/format.h>
#include <oblast/hull.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/read.h"
#include "io/row_measures.h"
#include "io/write.h"
#include "oblast/call_options.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/inputs.h"
#include "oblast/outputs.h"

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
  InputArguments input;
  OutputArguments output;
  bool quiet = false;
  CallOptions options;
};

int run(const Arguments& arguments, bool json) {
  const std::string& output = arguments.output.output;
  io::WriteOptions options = write_options(arguments.output);
  io::check_writable(output, options);
  const io::Layer layer = io::read(arguments.inputs, read_options(arguments.input, output));
  std::vector<std::string> notes = reading_notes("input", layer);
  append(notes, attributes_note("input", layer.columns));
  options.notes = &notes;
  RegionSet result;
  try {
    result = hull(RegionView(layer.regions), arguments.options);
  } catch (const Error& error) {
    if (error.place().contour == Place::npos) throw;
    throw io::IoError(fmt::format("{}: {}", io::describe(layer, error.place()), error.what()));
  }
  options.crs_wkt = layer.crs_wkt;
  io::write(output, result, options);
  if (!json || output != "-") print_notes(notes);
  if (json) {
    const nlohmann::ordered_json object{{"command", "hull"},
                                        {"output", output},
                                        {"input_vertices", layer.regions.points.size()},
                                        {"vertices", result.points.size()},
                                        {"area", signed_area(result)},
                                        {"notes", notes}};
    print_json(object, output);
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
  command->add_option("IN", a->inputs, input_help)->required()->type_name("");
  add_output_options(*command, a->output, invocation);
  add_input_options(*command, a->input);
  add_call_options(*command, a->options);
  command->add_flag("--json", invocation.json, "print the summary as one JSON object on standard output");
  command->add_flag("-q,--quiet", a->quiet, "print no summary");
  command->callback([a, &invocation] { invocation.run = [a, &invocation] { return run(*a, invocation.json); }; });
}

}  // namespace oblast::app
