// `oblast triangulate`: triangles, each with the number of its polygon.
#include <fmt/format.h>
#include <oblast/oblast.h>
#include <oblast/triangulate.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/read.h"
#include "io/write.h"
#include "oblast/call_options.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/inputs.h"
#include "oblast/interrupt.h"
#include "oblast/names.h"
#include "oblast/outputs.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
The input is united first. Every side of the union is a side of triangles. As far as these
sides allow, the triangulation is Delaunay; exact predicates decide. Each triangle is a
feature. Its attribute `polygon` is the number of the polygon that contains it, from 0 in
the order of `oblast union`, or -1 if no polygon contains it (--hull). WKT has no
attributes.

Example
  oblast triangulate districts.shp -o triangles.gpkg)";

struct Arguments {
  std::vector<std::string> inputs;
  InputArguments input;
  OutputArguments output;
  TriangulateOptions options;
  bool hull = false;
  bool strict = false;
  bool quiet = false;
};

/// A region set in which each triangle is a polygon.
RegionSet polygons_of(const Triangulation& triangulation) {
  RegionSet polygons;
  polygons.points.reserve(3 * triangulation.triangles.size());
  for (const auto& triangle : triangulation.triangles) {
    for (const std::uint32_t v : triangle) polygons.points.push_back(triangulation.points[v]);
    polygons.contour_ends.push_back(static_cast<std::uint32_t>(polygons.points.size()));
    polygons.polygon_ends.push_back(static_cast<std::uint32_t>(polygons.contour_ends.size()));
  }
  return polygons;
}

Triangulation compute(const io::Layer& layer, TriangulateOptions options, JobProgress& progress) {
  InterruptFlag watch;
  options.progress = [&](Stage stage, double fraction) {
    progress.show(Phase::computing, plain_name(stage), fraction);
    return !interrupted();
  };
  try {
    Triangulation result = triangulate(layer.regions, options);
    watch.end();
    return result;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) throw Interrupted();
    if (error.place().contour == Place::npos) throw;
    throw io::IoError(fmt::format("{}: {}", io::describe(layer, error.place()), error.what()));
  }
}

void report(const Triangulation& triangulation, const Arguments& arguments, const std::vector<std::string>& notes,
            bool json) {
  const std::string& output = arguments.output.output;
  if (!json || output != "-") print_notes(notes);
  if (json) {
    const nlohmann::ordered_json object{{"polygons", triangulation.regions.polygon_ends.size()},
                                        {"vertices", triangulation.points.size()},
                                        {"triangles", triangulation.triangles.size()},
                                        {"output", output},
                                        {"notes", notes}};
    print_json(object, output);
  } else if (!arguments.quiet) {
    fmt::print(stderr, "{} of {}, {}, to {}\n", counted(triangulation.triangles.size(), "triangle"),
               counted(triangulation.regions.polygon_ends.size(), "polygon"),
               counted(triangulation.points.size(), "vertex"), output);
  }
}

int run(const Arguments& arguments, bool json) {
  const std::string& output = arguments.output.output;
  io::WriteOptions writing_options = write_options(arguments.output);
  io::check_writable(output, writing_options);

  JobProgress progress(!arguments.quiet, false);
  progress.show(Phase::reading, "reading", 0);
  io::ReadOptions reading_options = read_options(arguments.input, output);
  reading_options.other = arguments.strict ? io::OtherGeometry::refuse : io::OtherGeometry::count_and_skip;
  const io::Layer layer = io::read(arguments.inputs, reading_options);
  std::vector<std::string> notes = reading_notes("input", layer);
  append(notes, attributes_note("input", layer.columns));
  writing_options.notes = &notes;
  TriangulateOptions options = arguments.options;
  options.extent = arguments.hull ? TriangleExtent::convex_hull : TriangleExtent::interior;
  const Triangulation triangulation = compute(layer, options, progress);

  progress.show(Phase::writing, "writing", 0);
  writing_options.crs_wkt = layer.crs_wkt;
  // The unsigned value `none` becomes -1.
  const std::vector<std::int32_t> numbers(triangulation.polygon.begin(), triangulation.polygon.end());
  writing_options.polygon_numbers = numbers;
  io::write(output, polygons_of(triangulation), writing_options);
  progress.clear();
  report(triangulation, arguments, notes, json);
  return exit_done;
}

}  // namespace

void add_triangulate(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments* const a = arguments.get();
  CLI::App* command =
      program.add_subcommand("triangulate", "Triangulate the union (constrained Delaunay), with polygon numbers.");
  command->footer(footer);
  command->add_option("IN", a->inputs, input_help)->required()->type_name("");
  add_output_options(*command, a->output, invocation);
  add_input_options(*command, a->input);
  command
      ->add_option_function<std::string>(
          "--fill", [a](const std::string& word) { a->options.fill_a = parse_fill(word); },
          "the fill rule: polygons (default), atleast:K, evenodd, nonzero, positive or negative")
      ->type_name("RULE");
  command->add_flag("--hull", a->hull, "also write the triangles outside the polygons, up to the convex hull");
  add_call_options(*command, a->options);
  command->add_flag("--strict", a->strict, "stop with an error at lines and points (default: skip them)");
  command->add_flag("--json", invocation.json, "print the summary as one JSON object on standard output");
  command->add_flag("-q,--quiet", a->quiet, "print no progress and no summary");
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
