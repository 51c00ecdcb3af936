// oblast_stop [INPUT [THREADS [TRIALS [ENGINE]]]]: how long a call works on after it was told to stop, and how long
// between two questions, with progress. One line an input: the largest times. INPUT is stars, slabs, clusters, hatch,
// nested or all; ENGINE 0, 1 or 2. On one thread times are those of the processor, so they hold in company too.
#include <oblast/oblast.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "faults/inputs.h"
#include "generators/hostile.h"
#include "generators/random.h"

namespace {

using namespace oblast;
bool one_thread = true;

/// Of the process on one thread, else of the wall.
double now() {
  if (one_thread) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Long thin rectangles across each other.
generators::Operands slabs(int count) {
  generators::Operands operands;
  for (int i = 0; i < count; ++i) {
    for (int s = 0; s < 2; ++s) {
      RegionSet& to = s == 0 ? operands.a : operands.b;
      const double at = i + 0.1;
      const Point corners[] = {{-1, at}, {count + 1.0, at + 0.3}, {count + 1.0, at + 0.7}, {-1, at + 0.4}};
      for (const Point& p : corners) to.points.push_back(s == 0 ? p : Point{p.y, p.x});
      to.contour_ends.push_back(static_cast<std::uint32_t>(to.points.size()));
      to.polygon_ends.push_back(static_cast<std::uint32_t>(to.contour_ends.size()));
    }
  }
  return operands;
}

constexpr const char* stage_names[] = {"collect", "node", "label", "select", "link", "assemble"};

struct Wait {
  double seconds = 0;
  Stage stage = Stage::collect;
  double fraction = 0;
};

/// The longest time between two questions, and where.
Wait longest_wait(const generators::Operands& operands, Options options, double& whole, int& questions) {
  Wait longest;
  const double begin = now();
  double last = begin;
  questions = 0;
  options.progress = [&](Stage stage, double fraction) {
    const double waited = now() - last;
    if (waited > longest.seconds) longest = {waited, stage, fraction};
    last = now();
    ++questions;
    return true;
  };
  overlay(operands.a, operands.b, Operation::unite, options);
  whole = now() - begin;
  return longest;
}

/// From the answer to stop to the end.
double time_to_end(const generators::Operands& operands, Options options, int last) {
  int asked = 0;
  double stopped = 0;
  options.progress = [&](Stage, double) {
    if (++asked < last) return true;
    stopped = now();
    return false;
  };
  try {
    overlay(operands.a, operands.b, Operation::unite, options);
  } catch (const Error&) {
    return now() - stopped;
  }
  return 0;
}

void measure(const char* name, const generators::Operands& operands, const Options& options, int trials) {
  double whole = 0;
  int questions = 0;
  const Wait wait = longest_wait(operands, options, whole, questions);
  generators::Random random(1);
  double longest_end = 0;
  for (int i = 0; i < trials; ++i)
    longest_end = std::max(longest_end, time_to_end(operands, options, 1 + random.below(questions)));
  std::printf(
      "%-9s %8zu vertices %7.2f s, %5d questions: longest between two %.3f s (before %s, %.2f), to the end %.3f s\n",
      name, operands.a.points.size() + operands.b.points.size(), whole, questions, wait.seconds,
      stage_names[static_cast<int>(wait.stage)], wait.fraction, longest_end);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const char* const input = argc > 1 ? argv[1] : "all";
  Options options;
  options.threads = argc > 2 ? std::atoi(argv[2]) : 1;
  one_thread = options.threads == 1;
  const int trials = argc > 3 ? std::atoi(argv[3]) : 20;
  options.engine = static_cast<Engine>(argc > 4 ? std::atoi(argv[4]) : 0);
  const auto wanted = [&](const char* name) { return std::strcmp(input, "all") == 0 || std::strcmp(input, name) == 0; };
  using oblast::testing::clusters, oblast::testing::hatch, oblast::testing::two_stars;
  if (wanted("stars")) measure("stars", two_stars(1000000), options, trials);
  if (wanted("slabs")) measure("slabs", slabs(500), options, trials);
  if (wanted("clusters")) measure("clusters", clusters(6000), options, trials);
  if (wanted("hatch")) measure("hatch", hatch(10000), options, trials);
  if (wanted("nested")) measure("nested", generators::nested_squares(3, 300000), options, trials);
}
