// oblast_hostile_buffers: random hostile shapes against the promises of buffer zones, and a table by generator.
//
//   oblast_hostile_buffers --cases 1000                                     of every generator
//   oblast_hostile_buffers --generator fans --first-seed 7 --cases 1        one case again
//
// The exit code is 1 when a case failed. "most_near" is the largest quotient of the lower bound by the distance of the
// outline, "most_far" that of the distance of its vertices by the upper bound: both are at most 1.
#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "buffer/buffer_trial.h"
#include "generators/hostile_table.h"

using namespace oblast;

int main(int argc, char** argv) {
  generators::HostileTable table;
  int largest = 40;
  CLI::App app{"Random hostile shapes against the promises of buffer zones, by generator"};
  table.add_options(app);
  app.add_option("--largest", largest, "edges of the largest case")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  std::vector<const char*> promises;
  for (int i = 0; i < testing::broken_buffer_count; ++i)
    promises.push_back(testing::to_text(static_cast<testing::BrokenBuffer>(i)));
  std::mutex mutex;
  testing::BufferFigures all;
  const auto take = [&] {
    const testing::BufferFigures f = std::exchange(all, {});
    return fmt::format(" {:>9.6f} {:>9.6f} {:>10} {:>8}", f.nearest, f.furthest, f.pockets, f.folded);
  };
  using Failure = generators::HostileTable::Failure;
  const auto run_case = [&](const generators::HostileGenerator& generator,
                            std::uint64_t seed) -> std::optional<Failure> {
    const int size = generators::size_of_hostile_case(seed, largest);
    const testing::BufferQuestion question = testing::draw_question(generator.make(seed, size), seed);
    testing::BufferFigures figures;
    const auto failure = testing::run_buffer_trial(question, seed, &figures);
    const std::lock_guard lock(mutex);
    all.add(figures);
    if (!failure) return {};
    return Failure{static_cast<int>(failure->broken), ": " + failure->what + "\n  " + testing::to_text(question)};
  };
  const std::string names = fmt::format(" {:>9} {:>9} {:>10} {:>8}", "most near", "most far", "pockets", "folded");
  return table.run(promises, {names, take}, run_case);
}
