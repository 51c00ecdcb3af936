// One measurement of one engine, for bench/engine_growth: a JSON object on one line.
//
//   oblast_engine_growth ENGINE FAMILY EDGES     stars: two polygons that cross a few times
//                                                squares: as many meetings as edges
#include <fmt/format.h>
#include <oblast/oblast.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

#include "generators/random.h"

namespace {

using namespace oblast;
using generators::Random;

void add(RegionSet& set, const std::vector<Point>& ring) {
  set.points.insert(set.points.end(), ring.begin(), ring.end());
  set.contour_ends.push_back(static_cast<std::uint32_t>(set.points.size()));
  set.polygon_ends.push_back(static_cast<std::uint32_t>(set.contour_ends.size()));
}

/// Around the origin, with five large waves and a random deviation at every vertex.
RegionSet star(std::size_t edges, double turn, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> ring;
  const double wiggle = 200.0 / static_cast<double>(edges);
  for (std::size_t i = 0; i < edges; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(edges);
    const double radius = 100 + 20 * std::sin(5 * angle + turn) + wiggle * random.in(-1, 1);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  RegionSet set;
  add(set, ring);
  return set;
}

/// Tilted squares in a larger one, whose size gives about as many meetings as edges for any number of squares.
RegionSet squares(std::size_t edges, std::uint64_t seed) {
  Random random(seed);
  RegionSet set;
  for (std::size_t i = 0; i < edges / 4; ++i) {
    const double side = std::sqrt(static_cast<double>(edges)), x = random.in(0, side), y = random.in(0, side);
    const double angle = random.in(0, 2), c = 1.1 * std::cos(angle), s = 1.1 * std::sin(angle);
    add(set, {{x, y}, {x + c, y + s}, {x + c - s, y + s + c}, {x - s, y + c}});
  }
  return set;
}

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("One union by one engine on one thread: time, time of the engine's own stages, memory.");
  std::string family;
  Engine engine{};
  std::size_t edges = 0;
  app.add_option("ENGINE", engine)
      ->required()
      ->transform(CLI::CheckedTransformer(std::map<std::string, Engine>{
          {"leonov-nikitin", Engine::leonov_nikitin}, {"vatti", Engine::vatti}, {"skvortsov", Engine::skvortsov}}));
  app.add_option("FAMILY", family)->required()->check(CLI::IsMember({"stars", "squares"}));
  app.add_option("EDGES", edges)->required()->check(CLI::Range(16, 1000000000));
  CLI11_PARSE(app, argc, argv);

  const bool stars = family == "stars";
  const RegionSet a = stars ? star(edges / 2, 0, 1) : squares(edges / 2, 1);
  const RegionSet b = stars ? star(edges / 2, 0.3, 2) : squares(edges / 2, 2);
  double best = 1e300, own = 0, all = 0;
  Statistics statistics;
  for (int run = 0; run < 9 && (run == 0 || all < 3); ++run) {
    statistics = {};
    Options options;
    options.engine = engine;
    options.threads = 1;
    options.statistics = &statistics;
    const auto begin = std::chrono::steady_clock::now();
    const RegionSet result = overlay(a, b, Operation::unite, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    all += seconds;
    if (seconds >= best) continue;
    best = seconds;
    const auto stage = [&](Stage s) { return statistics.seconds[static_cast<int>(s)]; };
    own = stage(Stage::label) + stage(Stage::select) + stage(Stage::link);
  }
  fmt::print(R"({{"edges": {}, "meetings": {}, "seconds": {:.6f}, "own_seconds": {:.6f}, "mib": {:.1f}}})"
             "\n",
             a.points.size() + b.points.size(), statistics.intersections, best, own, peak_mib());
  return 0;
}
