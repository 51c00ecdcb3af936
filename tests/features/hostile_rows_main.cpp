// oblast_hostile_rows: random hostile layers against the promises of rows, and a table by generator.
//
//   oblast_hostile_rows --cases 1000                    of every generator
//   oblast_hostile_rows --generator fans --first-seed 7 --cases 1     one case again
//   oblast_hostile_rows --repair --texts FILE      repairs in place of overlays; the results for tools/repairs-by-geos
//
// The exit code is 1 when a case failed.
#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <mutex>

#include "features/repair_trial.h"
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
  bool repair = false;
  std::string only, texts;
};

/// A broken promise, by its number.
struct Failure {
  int broken;
  std::string operation, what;
};

template <class Found>
std::optional<Failure> numbered(const std::optional<Found>& failure) {
  if (!failure) return {};
  return Failure{static_cast<int>(failure->broken), failure->operation, failure->what};
}

/// The names of the promises that a trial is about.
std::vector<const char*> names(const Settings& settings) {
  std::vector<const char*> all;
  for (int i = 0; i < (settings.repair ? testing::broken_repair_count : testing::broken_rows_count); ++i)
    all.push_back(settings.repair ? testing::to_text(static_cast<testing::BrokenRepair>(i))
                                  : testing::to_text(static_cast<testing::BrokenRows>(i)));
  return all;
}

/// A line for each feature: generator, seed, r (repaired) or c (of a coverage), WKT.
std::string lines(const char* generator, std::uint64_t seed, const testing::RepairedTexts& texts) {
  std::string all;
  for (const std::string& text : texts.features) all += fmt::format("{}\t{}\tr\t{}\n", generator, seed, text);
  for (const std::string& text : texts.coverage) all += fmt::format("{}\t{}\tc\t{}\n", generator, seed, text);
  return all;
}

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
  app.add_flag("--repair", settings.repair, "repair the layers in place of overlaying them");
  app.add_option("--texts", settings.texts, "with --repair: write the results here, as text");
  CLI11_PARSE(app, argc, argv);

  std::uint64_t total = 0, failures = 0;
  fmt::print("{:<22} {:>8}", "generator", "cases");
  const std::vector<const char*> promises = names(settings);
  for (const char* name : promises) fmt::print(" {:>10}", name);
  fmt::print("\n");
  std::ofstream texts;
  if (!settings.texts.empty()) texts.open(settings.texts);
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    if (!settings.only.empty() && settings.only != generator.name) continue;
    std::mutex mutex;
    std::vector<std::uint64_t> failed(promises.size());
    std::uint64_t shown = 0;
    tbb::parallel_for(settings.first_seed, settings.first_seed + settings.cases, [&](std::uint64_t seed) {
      const int size = size_of_case(settings, generator, seed);
      const generators::Operands operands = generator.make(seed, size);
      const bool exact = settings.exact > 0 && size <= 40 && seed % static_cast<std::uint64_t>(settings.exact) == 0;
      testing::RepairedTexts repaired;
      const auto failure = settings.repair ? numbered(testing::run_repair_trial(operands, seed, exact, &repaired))
                                           : numbered(testing::run_row_trial(operands, seed, exact));
      const std::lock_guard lock(mutex);
      if (texts.is_open()) texts << lines(generator.name, seed, repaired);
      if (!failure) return;
      ++failed[static_cast<std::size_t>(failure->broken)];
      if (shown++ >= settings.show) return;
      fmt::print("FAILED {} seed {}: {} in {}: {}\n", generator.name, seed,
                 promises[static_cast<std::size_t>(failure->broken)], failure->operation, failure->what);
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
