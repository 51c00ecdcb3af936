// oblast_zone_layers: the zones of real layers against Z1, Z2 and Z3, and a table of the largest epsilon by layer.
//
//   oblast_zone_layers                                     all layers of the shared test data
//   oblast_zone_layers --places 1000000 FILE[:LAYER]...    a million places at random, and as many on and beside
//   borders
//
// The exit code is 1 when a promise is broken. "asked", "proved" and "seen" are epsilons in the units of the
// coordinates; "seen" is at most "proved" and C.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "zone_layers/layer_zones.h"

using namespace oblast::testing;

namespace {

const char* const layers[] = {
    "realworld/bubenec.gpkg:buildings",
    "realworld/bubenec.gpkg:streets",
    "realworld/bubenec.gpkg:plots",
    "realworld/bubenec.gpkg:tessellation",
    "realworld/momepy-tests.gpkg:os",
    "realworld/momepy-tests.gpkg:network",
    "realworld/momepy-tests.gpkg:broken_network",
    "realworld/momepy-tests.gpkg:test_rabs",
    "realworld/berlin-districts.geojson",
    "realworld/brazil-states.geojson",
    "realworld/france-communes-hauts-de-france.geojson",
    "realworld/france-communes-normandie.geojson",
    "realworld/france-departements.geojson",
    "realworld/germany-counties-medium.geojson",
    "realworld/germany-districts-high.geojson",
    "realworld/germany-outline-very-high.geojson",
    "realworld/italy-municipalities-r5.geojson",
    "realworld/italy-regions.geojson",
    "realworld/russia-subjects.geojson",
    "geopandas/naturalearth_cities",
    "geopandas/naturalearth_lowres",
    "geopandas/nybb_16a.zip",
};

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> paths;
  LayerTrial trial;
  CLI::App app{"The zones of real layers against their promises, and the largest epsilon by layer"};
  app.add_option("LAYER", paths, "FILE or FILE:LAYER (default: all layers of " OBLAST_SHARED ")");
  app.add_option("--places", trial.places, "places at random, and as many on and beside borders")
      ->capture_default_str();
  app.add_option("--seed", trial.seed, "of the places")->capture_default_str();
  app.add_option("--relative", trial.relative_tolerance, "tolerance by the larger side of the box of all objects")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  if (paths.empty())
    for (const char* layer : layers) paths.push_back(std::string(OBLAST_SHARED) + "/" + layer);

  int failures = 0;
  fmt::print("{:<36} {:>7} {:>8} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8}\n", "layer", "objects", "vertices",
             "sites", "asked", "proved", "seen", "C", "places", "exactly", "excused");
  for (const std::string& path : paths) {
    const std::string name = path.substr(path.find_last_of('/') + 1);
    try {
      const LayerFigures f = judge_layer(path, trial);
      fmt::print("{:<36} {:>7} {:>8} {:>8} {:>9.2g} {:>9.2g} {:>9.2g} {:>9.2g} {:>9} {:>8} {:>8}\n", name, f.objects,
                 f.vertices, f.sites, f.tolerance, f.error, f.seen, f.rounding, f.places, f.exactly, f.excused);
      if (!f.fault.empty()) ++failures, fmt::print("FAILED {}: {}\n", name, f.fault);
    } catch (const std::exception& e) {
      ++failures;
      fmt::print("FAILED {}: {}\n", name, e.what());
    }
    std::fflush(stdout);
  }
  fmt::print("{} layers, {} failures\n", paths.size(), failures);
  return failures == 0 ? 0 : 1;
}
