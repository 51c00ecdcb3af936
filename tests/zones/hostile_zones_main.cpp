// oblast_hostile_zones: random hostile objects against the promises of proximity zones, and a table by generator.
//
//   oblast_hostile_zones --cases 1000                                     of every generator
//   oblast_hostile_zones --generator fans --first-seed 7 --cases 1        one case again
//
// The exit code is 1 when a case failed. "most proved" is the largest quotient of the epsilon that was proved by the
// one that was asked for, "most seen" that of the epsilon that was seen by the one that was proved: both are at most 1.
#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <mutex>

#include "generators/random.h"
#include "zones/zone_trial.h"

using namespace oblast;

int main(int argc, char** argv) {
  std::uint64_t cases = 100, first_seed = 1, show = 2, places = 300;
  int largest = 40;
  std::string only;
  bool print = false;
  CLI::App app{"Random hostile objects against the promises of proximity zones, by generator"};
  app.add_option("--cases", cases, "cases of every generator")->capture_default_str();
  app.add_option("--first-seed", first_seed, "seeds count up from here")->capture_default_str();
  app.add_option("--largest", largest, "edges of the largest case")->capture_default_str();
  app.add_option("--places", places, "places whose nearest object is tested, by case")->capture_default_str();
  app.add_option("--show", show, "failures shown, by generator")->capture_default_str();
  app.add_option("--generator", only, "only this one");
  app.add_flag("--print", print, "only print the questions, as failures are shown");
  CLI11_PARSE(app, argc, argv);

  std::uint64_t total = 0, failures = 0;
  fmt::print("{:<22} {:>8}", "generator", "cases");
  for (int i = 0; i < testing::broken_zones_count; ++i)
    fmt::print(" {:>10}", testing::to_text(static_cast<testing::BrokenZones>(i)));
  fmt::print(" {:>11} {:>9} {:>10} {:>8}\n", "most proved", "most seen", "sites", "excused");
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    if (!only.empty() && only != generator.name) continue;
    std::mutex mutex;
    std::uint64_t failed[testing::broken_zones_count] = {}, shown = 0;
    testing::ZoneFigures worst;
    tbb::parallel_for(first_seed, first_seed + cases, [&](std::uint64_t seed) {
      generators::Random random(seed ^ 0x73697a65);
      const double drawn = random.unit();
      const int size = 8 + static_cast<int>(drawn * drawn * std::max(1, largest - 7));
      const testing::ZoneQuestion question = testing::draw_zones(generator.make(seed, size), seed);
      if (print) {
        const std::lock_guard lock(mutex);
        fmt::print("{} seed {}:\n  {}\n", generator.name, seed, testing::to_text(question));
        return;
      }
      testing::ZoneFigures figures;
      const auto failure = testing::run_zone_trial(question, {seed, places, false}, &figures);
      const std::lock_guard lock(mutex);
      worst.proved = std::max(worst.proved, figures.proved);
      worst.seen = std::max(worst.seen, figures.seen);
      worst.sites += figures.sites;
      worst.excused += figures.excused;
      if (!failure) return;
      ++failed[static_cast<int>(failure->broken)];
      if (shown++ >= show) return;
      fmt::print("FAILED {} seed {}: {}: {}\n  {}\n", generator.name, seed, testing::to_text(failure->broken),
                 failure->what, testing::to_text(question));
      std::fflush(stdout);
    });
    fmt::print("{:<22} {:>8}", generator.name, cases);
    for (const std::uint64_t count : failed) {
      fmt::print(" {:>10}", count);
      failures += count;
    }
    fmt::print(" {:>11.6f} {:>9.6f} {:>10} {:>8}\n", worst.proved, worst.seen, worst.sites, worst.excused);
    std::fflush(stdout);
    total += cases;
  }
  fmt::print("{} cases, {} failures\n", total, failures);
  return failures == 0 && total > 0 ? 0 : 1;
}
