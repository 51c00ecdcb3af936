// oblast_hostile_rows: random hostile layers against the promises of rows, and a table by generator.
//
//   oblast_hostile_rows --cases 1000                    of every generator
//   oblast_hostile_rows --generator fans --first-seed 7 --cases 1     one case again
//
// The exit code is 1 when a case failed.
#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <map>
#include <mutex>

#include "features/row_trial.h"
#include "generators/random.h"
#include "generators/wkt.h"

namespace {

using namespace oblast;

struct Settings {
  std::uint64_t cases = 100, first_seed = 1;
  int largest = 0;
  int exact = 16;
  int large = 500;
  std::uint64_t show = 2;
  std::string only;
};

int size_of_case(const Settings& settings, const generators::HostileGenerator& generator, std::uint64_t seed) {
  generators::Random random(seed ^ 0x73697a65);
  const double drawn = random.unit();
  const int largest = settings.largest > 0 ? settings.largest : generator.usual;
  if (settings.large > 0 && random.one_in(settings.large)) return random.between(largest, generator.larger);
  return 8 + static_cast<int>(drawn * drawn * std::max(1, largest - 7));
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app{"Random hostile layers against the promises of rows, by generator"};
  app.add_option("--cases", settings.cases, "cases of every generator")->capture_default_str();
  app.add_option("--first-seed", settings.first_seed, "seeds count up from here")->capture_default_str();
  app.add_option("--largest", settings.largest, "edges of the largest case; 0: what is usual of the generator");
  app.add_option("--exact", settings.exact, "one of so many small cases is recomputed exactly; 0: none")
      ->capture_default_str();
  app.add_option("--large", settings.large, "one of so many cases has hundreds of edges; 0: none")
      ->capture_default_str();
  app.add_option("--show", settings.show, "failures shown, by generator")->capture_default_str();
  app.add_option("--generator", settings.only, "only this one");
  CLI11_PARSE(app, argc, argv);

  std::uint64_t total = 0, failures = 0;
  fmt::print("{:<22} {:>8}", "generator", "cases");
  for (int i = 0; i < testing::broken_rows_count; ++i)
    fmt::print(" {:>10}", testing::to_text(static_cast<testing::BrokenRows>(i)));
  fmt::print("\n");
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    if (!settings.only.empty() && settings.only != generator.name) continue;
    std::mutex mutex;
    std::uint64_t failed[testing::broken_rows_count] = {}, shown = 0;
    tbb::parallel_for(settings.first_seed, settings.first_seed + settings.cases, [&](std::uint64_t seed) {
      const int size = size_of_case(settings, generator, seed);
      const generators::Operands operands = generator.make(seed, size);
      const bool exact = settings.exact > 0 && size <= 40 && seed % static_cast<std::uint64_t>(settings.exact) == 0;
      const auto failure = testing::run_row_trial(operands, seed, exact);
      if (!failure) return;
      const std::lock_guard lock(mutex);
      ++failed[static_cast<int>(failure->broken)];
      if (shown++ >= settings.show) return;
      fmt::print("FAILED {} seed {}: {} in {}: {}\n", generator.name, seed, testing::to_text(failure->broken),
                 failure->operation, failure->what);
      if (size <= 40)
        fmt::print("  A {}\n  B {}\n", generators::soup_to_wkt(operands.a), generators::soup_to_wkt(operands.b));
      std::fflush(stdout);
    });
    fmt::print("{:<22} {:>8}", generator.name, settings.cases);
    for (const std::uint64_t count : failed) {
      fmt::print(" {:>10}", count);
      failures += count;
    }
    fmt::print("\n");
    std::fflush(stdout);
    total += settings.cases;
  }
  fmt::print("{} cases, {} failures\n", total, failures);
  return failures == 0 && total > 0 ? 0 : 1;
}
