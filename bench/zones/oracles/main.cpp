// oblast_zones_oracle: the steps of bench/zones/oracle that need oblast or its verifier. Each prints JSON.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "zones/oracles/nearest.h"
#include "zones/oracles/neighbours.h"

int main(int argc, char** argv) {
  CLI::App app{"The steps of bench/zones/oracle"};
  app.require_subcommand(1);
  zones::NearestFiles files;
  std::uint64_t count = 1000, seed = 1;
  double tolerance = 0, error = 0, rounding = 0;
  std::string shapes, neighbours;

  CLI::App* places = app.add_subcommand("places", "Draw places, and write the objects whose zones hold them.");
  CLI::App* judge = app.add_subcommand("judge", "Compare these objects with the answers of an oracle.");
  for (CLI::App* command : {places, judge}) {
    command->add_option("SHAPES", files.shapes)->required();
    command->add_option("PLACES", files.places)->required();
    command->add_option("ROWS", files.rows)->required();
  }
  places->add_option("--count", count);
  places->add_option("--seed", seed);
  places->add_option("--tolerance", tolerance, "in units of the coordinates; 0: the default");
  judge->add_option("ANSWERS", files.answers)->required();
  judge->add_option("--error", error)->required();
  judge->add_option("--rounding", rounding)->required();
  CLI::App* compare = app.add_subcommand("neighbours", "Compare zones of points with a Delaunay triangulation.");
  compare->add_option("SHAPES", shapes)->required();
  compare->add_option("NEIGHBOURS", neighbours, "written by neighbours_by_cgal")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    const nlohmann::json report = *places  ? zones::write_places(files, count, seed, tolerance)
                                  : *judge ? zones::judge_answers(files, error, rounding)
                                           : zones::judge_neighbours(shapes, neighbours);
    std::printf("%s\n", report.dump().c_str());
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
