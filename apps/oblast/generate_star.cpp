// `oblast generate star`: one large wavy polygon. Two of them, with different turns, cross in few points.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>

#include "io/write.h"
#include "oblast/console.h"
#include "oblast/generate.h"

namespace oblast::app {

namespace {

constexpr const char* footer = R"(
A star-shaped polygon around the origin. Its radius is about 1000 units, with five large
waves, fifty small waves and a random deviation at every vertex.

Example: two polygons of a million vertices each, and their intersection
  oblast generate star -n 1000000 -o a.gpkg
  oblast generate star -n 1000000 --turn 0.3 --seed 2 -o b.gpkg
  oblast overlay intersection a.gpkg b.gpkg -o both.gpkg --merge)";

struct Arguments {
  std::string output;
  std::uint32_t vertices = 1000000;
  std::uint64_t seed = 1;
  double turn = 0;
  bool overwrite = false, quiet = false;
};

/// The polygon is simple because its angles increase.
RegionSet star(const Arguments& arguments) {
  std::mt19937_64 random(arguments.seed);
  const double step = 2 * std::numbers::pi / arguments.vertices;
  RegionSet star;
  for (std::uint32_t i = 0; i < arguments.vertices; ++i) {
    const double angle = step * i;
    const double wiggle = (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) * step * 2 / 3;
    const double radius = 1000 * (1 + 0.2 * std::sin(5 * (angle + arguments.turn)) +
                                  0.01 * std::sin(50 * (angle - arguments.turn)) + wiggle);
    star.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  star.contour_ends = {arguments.vertices};
  star.polygon_ends = {1};
  return star;
}

int run(const Arguments& arguments) {
  io::WriteOptions options;
  options.existing = arguments.overwrite ? io::Existing::overwrite : io::Existing::refuse;
  io::check_writable(arguments.output, options);
  io::write(arguments.output, star(arguments), options);
  if (!arguments.quiet) fmt::print(stderr, "{}: {}\n", arguments.output, counted(arguments.vertices, "vertex"));
  return exit_done;
}

}  // namespace

void add_generate_star(CLI::App& generate, Invocation& invocation) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = generate.add_subcommand("star", "One large wavy polygon.");
  command->footer(footer);
  command->add_option("-o,--output", a->output, "file for the polygon; `-`: WKT on standard output")
      ->required()
      ->type_name("OUT");
  command->add_option("-n,--vertices", a->vertices, "number of vertices, 3 to 100 million (1000000)")
      ->check(CLI::Range(3U, 100000000U))
      ->type_name("N");
  command->add_option("--turn", a->turn, "angle in radians by which the waves are turned (0)")->type_name("X");
  command->add_option("--seed", a->seed, "seed of the random deviations (1)")->type_name("N");
  command->add_flag("--overwrite", a->overwrite, "replace an existing file");
  command->add_flag("-q,--quiet", a->quiet, "print no summary");
  command->callback([a, &invocation] { invocation.run = [a] { return run(*a); }; });
}

}  // namespace oblast::app
