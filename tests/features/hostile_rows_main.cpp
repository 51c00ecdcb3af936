// oblast_hostile_rows: random hostile layers against the promises of rows, and a table by generator.
//
//   oblast_hostile_rows --cases 1000                    of every generator
//   oblast_hostile_rows --generator fans --first-seed 7 --cases 1     one case again
//   oblast_hostile_rows --repair --texts FILE      repairs in place of overlays; the results for tools/repairs-by-geos
//
// The exit code is 1 when a case failed.
#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <mutex>

#include "features/repair_trial.h"
#include "features/row_trial.h"
#include "generators/hostile_table.h"
#include "generators/random.h"
#include "generators/wkt.h"

namespace {

using namespace oblast;

struct Settings {
  int largest = 0;
  int exact = 16;
  int large = 500;
  bool repair = false;
  std::string texts;
};

using Failure = generators::HostileTable::Failure;

template <class Found>
std::optional<Failure> numbered(const std::optional<Found>& failure) {
  if (!failure) return {};
  return Failure{static_cast<int>(failure->broken), " in " + failure->operation + ": " + failure->what};
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
  const int largest = settings.largest > 0 ? settings.largest : generator.usual;
  generators::Random random(seed ^ 0x6c61726765);
  if (settings.large > 0 && random.one_in(settings.large)) return random.between(largest, generator.larger);
  return generators::size_of_hostile_case(seed, largest);
}

}  // namespace

int main(int argc, char** argv) {
  generators::HostileTable table;
  Settings settings;
  CLI::App app{"Random hostile layers against the promises of rows, by generator"};
  table.add_options(app);
  app.add_option("--largest", settings.largest, "edges of the largest case; 0: what is usual of the generator");
  app.add_option("--exact", settings.exact, "one of so many small cases is recomputed exactly; 0: none")
      ->capture_default_str();
  app.add_option("--large", settings.large, "one of so many cases has hundreds of edges; 0: none")
      ->capture_default_str();
  app.add_flag("--repair", settings.repair, "repair the layers in place of overlaying them");
  app.add_option("--texts", settings.texts, "with --repair: write the results here, as text");
  CLI11_PARSE(app, argc, argv);

  std::ofstream texts;
  if (!settings.texts.empty()) texts.open(settings.texts);
  std::mutex mutex;
  const auto run_case = [&](const generators::HostileGenerator& generator, std::uint64_t seed) {
    const int size = size_of_case(settings, generator, seed);
    const generators::Operands operands = generator.make(seed, size);
    const bool exact = settings.exact > 0 && size <= 40 && seed % static_cast<std::uint64_t>(settings.exact) == 0;
    testing::RepairedTexts repaired;
    auto failure = settings.repair ? numbered(testing::run_repair_trial(operands, seed, exact, &repaired))
                                   : numbered(testing::run_row_trial(operands, seed, exact));
    if (failure && size <= 40)
      failure->what += "\n  A " + generators::soup_to_wkt(operands.a) + "\n  B " + generators::soup_to_wkt(operands.b);
    const std::lock_guard lock(mutex);
    if (texts.is_open()) texts << lines(generator.name, seed, repaired);
    return failure;
  };
  return table.run(names(settings), {}, run_case);
}
