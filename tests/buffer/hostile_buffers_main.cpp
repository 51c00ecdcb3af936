// oblast_hostile_buffers: random hostile shapes against the promises of buffer zones, and a table by generator.
//
//   oblast_hostile_buffers --cases 1000                                     of every generator
//   oblast_hostile_buffers --generator fans --first-seed 7 --cases 1        one case again
//
// The exit code is 1 when a case failed. "most_near" is the largest quotient of the lower bound by the distance of the
// outline, "most_far" that of the distance of its vertices by the upper bound: both are at most 1.
#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <mutex>

#include "buffer/buffer_trial.h"
#include "generators/random.h"

using namespace oblast;

int main(int argc, char** argv) {
  std::uint64_t cases = 100, first_seed = 1, show = 2;
  int largest = 40;
  std::string only;
  CLI::App app{"Random hostile shapes against the promises of buffer zones, by generator"};
  app.add_option("--cases", cases, "cases of every generator")->capture_default_str();
  app.add_option("--first-seed", first_seed, "seeds count up from here")->capture_default_str();
  app.add_option("--largest", largest, "edges of the largest case")->capture_default_str();
  app.add_option("--show", show, "failures shown, by generator")->capture_default_str();
  app.add_option("--generator", only, "only this one");
  CLI11_PARSE(app, argc, argv);

  std::uint64_t total = 0, failures = 0;
  fmt::print("{:<22} {:>8}", "generator", "cases");
  for (int i = 0; i < testing::broken_buffer_count; ++i)
    fmt::print(" {:>8}", testing::to_text(static_cast<testing::BrokenBuffer>(i)));
  fmt::print(" {:>9} {:>9} {:>10} {:>8}\n", "most near", "most far", "pockets", "folded");
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    if (!only.empty() && only != generator.name) continue;
    std::mutex mutex;
    std::uint64_t failed[testing::broken_buffer_count] = {}, shown = 0;
    testing::BufferFigures worst;
    tbb::parallel_for(first_seed, first_seed + cases, [&](std::uint64_t seed) {
      generators::Random random(seed ^ 0x73697a65);
      const double drawn = random.unit();
      const int size = 8 + static_cast<int>(drawn * drawn * std::max(1, largest - 7));
      const testing::BufferQuestion question = testing::draw_question(generator.make(seed, size), seed);
      testing::BufferFigures figures;
      const auto failure = testing::run_buffer_trial(question, seed, &figures);
      const std::lock_guard lock(mutex);
      worst.nearest = std::max(worst.nearest, figures.nearest);
      worst.furthest = std::max(worst.furthest, figures.furthest);
      worst.pockets += figures.pockets;
      worst.folded += figures.folded;
      if (!failure) return;
      ++failed[static_cast<int>(failure->broken)];
      if (shown++ >= show) return;
      fmt::print("FAILED {} seed {}: {}: {}\n  {}\n", generator.name, seed, testing::to_text(failure->broken),
                 failure->what, testing::to_text(question));
      std::fflush(stdout);
    });
    fmt::print("{:<22} {:>8}", generator.name, cases);
    for (const std::uint64_t count : failed) {
      fmt::print(" {:>8}", count);
      failures += count;
    }
    fmt::print(" {:>9.6f} {:>9.6f} {:>10} {:>8}\n", worst.nearest, worst.furthest, worst.pockets, worst.folded);
    std::fflush(stdout);
    total += cases;
  }
  fmt::print("{} cases, {} failures\n", total, failures);
  return failures == 0 && total > 0 ? 0 : 1;
}
