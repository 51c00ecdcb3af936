// Checks on real files that a union has the same bytes if its polygons are shuffled, if its contours are reversed and
// rotated as far as the fill rule allows, on 1, 2 and 8 threads, with every requested engine, and if it is united
// again.
//
//   oblast_same_bytes [--engines] FILE_OR_FOLDER...
#include <fmt/format.h>
#include <oblast/oblast.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "generators/trial.h"
#include "io/read.h"

namespace {

using namespace oblast;

struct Rule {
  const char* name;
  FillRule rule;
};

const Rule rules[] = {{"polygons", FillRule::polygons()},
                      {"atleast:2", FillRule::at_least(2)},
                      {"nonzero", FillRule::nonzero()},
                      {"evenodd", FillRule::even_odd()},
                      {"positive", FillRule::positive()}};

class Comparison {
 public:
  explicit Comparison(const char* rule) : rule_(rule) {}

  void add(const std::string& what, const RegionSet& first, const RegionSet& second) {
    const bool same = first == second;
    differing_ += !same;
    fmt::print("{:<12} {:<34} {}\n", rule_, what, same ? "same bytes" : "DIFFERS");
  }
  int differing() const { return differing_; }

 private:
  const char* rule_;
  int differing_ = 0;
};

int compare(const RegionSet& layer, const Rule& rule, bool engines) {
  Options options;
  options.fill_a = rule.rule;
  const RegionSet united = unite(layer, options);
  fmt::print("{:<12} {} polygons, {} contours, {} vertices\n", rule.name, united.polygon_ends.size(),
             united.contour_ends.size(), united.points.size());
  Comparison comparison(rule.name);
  for (const int threads : {1, 2, 8}) {
    Options threaded = options;
    threaded.threads = threads;
    comparison.add(fmt::format("{} threads", threads), united, unite(layer, threaded));
  }
  for (const std::uint64_t seed : {1, 2})
    comparison.add(fmt::format("shuffled and reversed, seed {}", seed), united,
                   unite(generators::shuffled(layer, rule.rule, seed), options));
  for (const ContourConvention convention : {ContourConvention::ogc, ContourConvention::leonov_nikitin}) {
    Options first = options, again;
    first.contours = again.contours = convention;
    const bool ogc = convention == ContourConvention::ogc;
    const RegionSet once = ogc ? united : unite(layer, first);
    comparison.add(fmt::format("united again ({})", ogc ? "ogc" : "leonov-nikitin"), once, unite(once, again));
  }
  if (engines) {
    for (const Engine engine : {Engine::vatti, Engine::skvortsov}) {
      Options other = options;
      other.engine = engine;
      comparison.add(engine == Engine::vatti ? "engine vatti" : "engine skvortsov", united, unite(layer, other));
    }
  }
  return comparison.differing();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Unites a layer in other orders, directions and threads, and again; exit code 1 when any byte differs.");
  std::vector<std::string> paths;
  bool engines = false;
  app.add_option("PATH", paths, "vector files or folders, one operand")->required();
  app.add_flag("--engines", engines, "the other engines too");
  CLI11_PARSE(app, argc, argv);
  int differing = 0;
  try {
    const io::Layer layer = io::read(paths);
    for (const Rule& rule : rules) differing += compare(layer.regions, rule, engines);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  fmt::print("{} differing\n", differing);
  return differing == 0 ? 0 : 1;
}
