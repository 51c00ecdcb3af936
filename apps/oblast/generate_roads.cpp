// `oblast generate roads`: writes the network of roads.h as lines.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "io/crs.h"
#include "io/write_points.h"
#include "oblast/console.h"
#include "oblast/generate.h"
#include "oblast/roads.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
Towns with a grid of streets, and winding roads from town to town. Coordinates are metres
(EPSG:3035) with two digits after the point. Each line has a column `kind`: street or road.
The same number and seed give the same coordinates on every machine.

Example: everything within 30 m of half a million segments
  oblast generate roads -n 500000 -o roads.gpkg
  oblast buffer roads.gpkg --distance 30m -o near.gpkg --svg near.svg)";

struct Arguments {
  std::string output;
  std::uint32_t segments = 100000;
  std::uint64_t seed = 1;
  bool overwrite = false, quiet = false;
};

int run(const Arguments& arguments) {
  io::WriteOptions options;
  options.existing = arguments.overwrite ? io::Existing::overwrite : io::Existing::refuse;
  options.crs_wkt = io::crs_from_text(roads_crs);
  io::check_writable(arguments.output, options);
  RoadNetwork roads = generate_roads(arguments.segments, arguments.seed);
  const io::PlaceColumn kinds[] = {{"kind", std::move(roads.kinds)}};
  io::write_lines(arguments.output, {roads.vertices, roads.ends}, kinds, options);
  if (!arguments.quiet)
    fmt::print(stderr, "{}: {}, {}\n", arguments.output, counted(roads.ends.size(), "line"),
               counted(roads.segments(), "segment"));
  return exit_done;
}

}  // namespace

void add_generate_roads(CLI::App& generate, Invocation& invocation) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = generate.add_subcommand("roads", "Lines like streets and roads.");
  command->footer(footer);
  command->add_option("-o,--output", a->output, "file for the lines; `-`: WKT on standard output")
      ->required()
      ->type_name("OUT");
  command->add_option("-n,--segments", a->segments, "number of segments, 1 to 100 million (100000)")
      ->check(CLI::Range(1U, 100000000U))
      ->type_name("N");
  command->add_option("--seed", a->seed, "seed of the network (1)")->type_name("N");
  command->add_flag("--overwrite", a->overwrite, "replace an existing file");
  command->add_flag("-q,--quiet", a->quiet, "print no summary");
  command->callback([a, &invocation] { invocation.run = [a] { return run(*a); }; });
}

}  // namespace oblast::app
