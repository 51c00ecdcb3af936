// `oblast triangulate`: triangles, each with the number of its polygon.
#include <fmt/format.h>
#include <oblast/oblast.h>
#include <oblast/triangulate.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "io/read.h"
#include "io/write.h"
#include "oblast/call_options.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/interrupt.h"
#include "oblast/names.h"

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
  std::string output;
  TriangulateOptions options;
  bool hull = false;
  bool overwrite = false;
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

void report(const Triangulation& triangulation, const Arguments& arguments, bool json) {
  if (json) {
    const nlohmann::ordered_json object{{"polygons", triangulation.regions.polygon_ends.size()},
                                        {"vertices", triangulation.points.size()},
                                        {"triangles", triangulation.triangles.size()},
                                        {"output", arguments.output}};
    fmt::print("{}\n", object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!arguments.quiet) {
    fmt::print(stderr, "{} of {}, {}, to {}\n", counted(triangulation.triangles.size(), "triangle"),
               counted(triangulation.regions.polygon_ends.size(), "polygon"),
               counted(triangulation.points.size(), "vertex"), arguments.output);
  }
}

int run(const Arguments& arguments, bool json) {
  if (json && arguments.output == "-")
    throw CallError("--json and `-o -` both write to standard output; leave one of them out");
  io::WriteOptions write_options;
  write_options.existing = arguments.overwrite ? io::Existing::overwrite : io::Existing::refuse;
  io::check_writable(arguments.output, write_options);

  JobProgress progress(!arguments.quiet, false);
  progress.show(Phase::reading, "reading", 0);
  io::ReadOptions read_options;
  read_options.other = arguments.strict ? io::OtherGeometry::refuse : io::OtherGeometry::count_and_skip;
  const io::Layer layer = io::read(arguments.inputs, read_options);
  TriangulateOptions options = arguments.options;
  options.extent = arguments.hull ? TriangleExtent::convex_hull : TriangleExtent::interior;
  const Triangulation triangulation = compute(layer, options, progress);

  progress.show(Phase::writing, "writing", 0);
  write_options.crs_wkt = layer.crs_wkt;
  // The unsigned value `none` becomes -1.
  const std::vector<std::int32_t> numbers(triangulation.polygon.begin(), triangulation.polygon.end());
  write_options.polygon_numbers = numbers;
  io::write(arguments.output, polygons_of(triangulation), write_options);
  progress.clear();
  report(triangulation, arguments, json);
  return exit_done;
}

}  // namespace

void add_triangulate(CLI::App& program, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments* const a = arguments.get();
  CLI::App* command =
      program.add_subcommand("triangulate", "Triangulate the union (constrained Delaunay), with polygon numbers.");
  command->footer(footer);
  command->add_option("IN", a->inputs, "vector files or folders; `-`: WKT on standard input")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", a->output, "file for the triangles; `-`: WKT on standard output")
      ->required()
      ->type_name("OUT");
  command
      ->add_option_function<std::string>(
          "--fill", [a](const std::string& word) { a->options.fill_a = parse_fill(word); },
          "the fill rule: polygons (default), atleast:K, evenodd, nonzero, positive or negative")
      ->type_name("RULE");
  command->add_flag("--hull", a->hull, "also write the triangles outside the polygons, up to the convex hull");
  add_call_options(*command, a->options);
  command->add_flag("--overwrite", a->overwrite, "replace existing files");
  command->add_flag("--strict", a->strict, "stop with an error at lines and points (default: skip them)");
  command->add_flag("--json", invocation.json, "print the summary as one JSON object on standard output");
  command->add_flag("-q,--quiet", a->quiet, "print no progress and no summary");
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
