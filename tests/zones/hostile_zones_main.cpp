// oblast_hostile_zones: random hostile objects against the promises of proximity zones, and a table by generator.
//
//   oblast_hostile_zones --cases 1000                                     of every generator
//   oblast_hostile_zones --generator fans --first-seed 7 --cases 1        one case again
//
// The exit code is 1 when a case failed. "most proved" is the largest quotient of the epsilon that was proved by the
// one that was asked for, "most seen" that of the epsilon that was seen by the one that was proved: both are at most 1.
#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "generators/hostile_table.h"
#include "zones/zone_trial.h"

using namespace oblast;

int main(int argc, char** argv) {
  generators::HostileTable table;
  std::uint64_t places = 300;
  int largest = 40;
  bool print = false;
  CLI::App app{"Random hostile objects against the promises of proximity zones, by generator"};
  table.add_options(app);
  app.add_option("--largest", largest, "edges of the largest case")->capture_default_str();
  app.add_option("--places", places, "places whose nearest object is tested, by case")->capture_default_str();
  app.add_flag("--print", print, "only print the questions, as failures are shown");
  CLI11_PARSE(app, argc, argv);

  std::vector<const char*> promises;
  for (int i = 0; i < testing::broken_zones_count; ++i)
    promises.push_back(testing::to_text(static_cast<testing::BrokenZones>(i)));
  std::mutex mutex;
  testing::ZoneFigures all;
  const auto take = [&] {
    const testing::ZoneFigures f = std::exchange(all, {});
    return fmt::format(" {:>11.6f} {:>9.6f} {:>10} {:>8}", f.proved, f.seen, f.sites, f.excused);
  };
  using Failure = generators::HostileTable::Failure;
  const auto run_case = [&](const generators::HostileGenerator& generator,
                            std::uint64_t seed) -> std::optional<Failure> {
    const int size = generators::size_of_hostile_case(seed, largest);
    const testing::ZoneQuestion question = testing::draw_zones(generator.make(seed, size), seed);
    testing::ZoneFigures figures;
    const auto failure = print ? std::nullopt : testing::run_zone_trial(question, {seed, places, false}, &figures);
    const std::lock_guard lock(mutex);
    if (print) fmt::print("{} seed {}:\n  {}\n", generator.name, seed, testing::to_text(question));
    all.add(figures);
    if (!failure) return {};
    return Failure{static_cast<int>(failure->broken), ": " + failure->what + "\n  " + testing::to_text(question)};
  };
  const std::string names = fmt::format(" {:>11} {:>9} {:>10} {:>8}", "most proved", "most seen", "sites", "excused");
  return table.run(promises, {names, take}, run_case);
}
