// `oblast classic`: runs one of the classic methods; an error outside its domain.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/picture.h"
#include "io/picture_file.h"
#include "io/write.h"
#include "oblast/call_options.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/inputs.h"
#include "oblast/job.h"
#include "oblast/methods.h"
#include "oblast/names.h"
#include "oblast/outputs.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
METHOD                accepts
  orourke             A and B are one convex contour each
  sutherland-hodgman  A is any polygon, B is one convex contour; intersection only
  weiler-atherton     in each operand contours meet at vertices only, and the interior is
                      on the same side of all of them; holes are allowed
  margalit-knott      A and B are one contour each, whose edges are disjoint, meet at
                      their ends, or coincide
For any other input the error names the contour, the vertex and another method. For input
that a method accepts, the result has the same bytes as that of `oblast overlay --merge`.

Example
  oblast classic sutherland-hodgman intersection land.gpkg window.gpkg -o clip.gpkg)";

struct Arguments {
  ClassicMethod method = ClassicMethod::orourke;
  std::string word;
  Operation operation = Operation::intersection;
  std::string a, b, picture;
  InputArguments input;
  OutputArguments output;
  bool quiet = false;
  CallOptions options;
};

void report(const Arguments& arguments, const RegionSet& result, const ClassicReport& done, double seconds,
            const std::vector<std::string>& notes, bool json) {
  if (!json || arguments.output.output != "-") print_notes(notes);
  if (json) {
    const nlohmann::ordered_json object{{"command", "classic"},
                                        {"method", arguments.word},
                                        {"operation", name(arguments.operation)},
                                        {"output", arguments.output.output},
                                        {"polygons", result.polygon_ends.size()},
                                        {"contours", result.contour_ends.size()},
                                        {"vertices", result.points.size()},
                                        {"area", signed_area(result)},
                                        {"meetings", done.meetings},
                                        {"handed_over", done.handed_over},
                                        {"seconds", seconds},
                                        {"notes", notes}};
    print_json(object, arguments.output.output);
  } else if (!arguments.quiet) {
    fmt::print(stderr, "{} {}: {}, {}, area {:.10g}, {} meetings, {:.6f} s{}\n", arguments.word,
               name(arguments.operation), counted(result.contour_ends.size(), "contour"),
               counted(result.points.size(), "vertex"), signed_area(result), grouped(done.meetings), seconds,
               done.handed_over ? " (edges are too close for this method; the noding of `overlay` computed it)" : "");
  }
}

int run(const Arguments& arguments, bool json) {
  if (arguments.a == "-" && arguments.b == "-") throw CallError("standard input (-) can be named only once");
  const std::string& output = arguments.output.output;
  io::WriteOptions options = write_options(arguments.output);
  const io::Existing existing = options.existing;
  io::check_writable(output, options);
  check_picture_call(arguments.picture, output, json);
  if (!arguments.picture.empty()) io::check_picture_writable(arguments.picture, existing);
  const OperandPair pair = read_pair(arguments.a, arguments.b, read_options(arguments.input, output));
  std::vector<std::string> notes = notes_of(pair);
  options.notes = &notes;
  ClassicReport done;
  RegionSet result;
  const auto begin = std::chrono::steady_clock::now();
  try {
    result = classic(arguments.method, pair.a.regions, pair.b.regions, arguments.operation, &done, arguments.options);
  } catch (const Error& error) {
    throw io::IoError(describe(pair, error));
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  options.crs_wkt = pair.crs_wkt();
  io::write(output, result, options);
  if (!arguments.picture.empty()) {
    io::Picture picture;
    picture.a = pair.a.regions;
    picture.b = pair.b.regions;
    picture.result = result;
    picture.title = fmt::format("{} by {}", name(arguments.operation), arguments.word);
    if (pair.crs_wkt().rfind("GEOG", 0) == 0) picture.projection = io::MapProjection::longitude_latitude;
    io::write_picture(arguments.picture, io::to_svg(picture), existing);
  }
  report(arguments, result, done, spent.count(), notes, json);
  return exit_done;
}

}  // namespace

void add_classic(CLI::App& program, Invocation& invocation) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("classic", "Overlay two operands by a classic method.");
  command->footer(footer);
  command
      ->add_option_function<std::string>(
          "METHOD",
          [a](const std::string& word) {
            a->method = parse_classic(word);
            a->word = word;
          },
          "the method: orourke, sutherland-hodgman, weiler-atherton or margalit-knott")
      ->required()
      ->type_name("");
  command
      ->add_option_function<std::string>(
          "OP", [a](const std::string& word) { a->operation = parse_operation(word); },
          "the operation: intersection, union or difference")
      ->required()
      ->type_name("");
  command->add_option("A", a->a, input_help)->required()->type_name("");
  command->add_option("B", a->b, "the second operand, as A")->required()->type_name("");
  add_output_options(*command, a->output, invocation);
  add_input_options(*command, a->input);
  add_call_options(*command, a->options);
  command->add_option("--svg,--picture", a->picture, picture_option)->type_name("PICTURE");
  command->add_flag("--json", invocation.json, "print the summary as one JSON object on standard output");
  command->add_flag("-q,--quiet", a->quiet, "print no summary");
  command->callback([a, &invocation] { invocation.run = [a, &invocation] { return run(*a, invocation.json); }; });
}

}  // namespace oblast::app
