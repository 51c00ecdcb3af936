#include "generators/hostile_table.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdio>
#include <mutex>

#include "generators/random.h"

namespace oblast::generators {

void HostileTable::add_options(CLI::App& app) {
  app.add_option("--cases", cases, "cases of every generator")->capture_default_str();
  app.add_option("--first-seed", first_seed, "seeds count up from here")->capture_default_str();
  app.add_option("--show", show, "failures shown, by generator")->capture_default_str();
  app.add_option("--generator", only, "only this one");
}

int HostileTable::run(const std::vector<const char*>& promises, const Figures& figures, const Case& run_case) const {
  std::uint64_t total = 0, failures = 0;
  fmt::print("{:<22} {:>8}", "generator", "cases");
  for (const char* name : promises) fmt::print(" {:>10}", name);
  fmt::print("{}\n", figures.names);
  for (const HostileGenerator& generator : hostile_generators()) {
    if (!only.empty() && only != generator.name) continue;
    std::mutex mutex;
    std::vector<std::uint64_t> failed(promises.size());
    std::uint64_t shown = 0;
    tbb::parallel_for(first_seed, first_seed + cases, [&](std::uint64_t seed) {
      const auto failure = run_case(generator, seed);
      if (!failure) return;
      const std::lock_guard lock(mutex);
      const auto broken = static_cast<std::size_t>(failure->broken);
      ++failed[broken];
      if (shown++ >= show) return;
      fmt::print("FAILED {} seed {}: {}{}\n", generator.name, seed, promises[broken], failure->what);
      std::fflush(stdout);
    });
    fmt::print("{:<22} {:>8}", generator.name, cases);
    for (const std::uint64_t count : failed) {
      fmt::print(" {:>10}", count);
      failures += count;
    }
    fmt::print("{}\n", figures.take ? figures.take() : "");
    std::fflush(stdout);
    total += cases;
  }
  fmt::print("{} cases, {} failures\n", total, failures);
  return failures == 0 && total > 0 ? 0 : 1;
}

int size_of_hostile_case(std::uint64_t seed, int largest) {
  const double drawn = Random(seed ^ 0x73697a65).unit();
  return 8 + static_cast<int>(drawn * drawn * std::max(1, largest - 7));
}

}  // namespace oblast::generators
