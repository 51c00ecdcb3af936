// oblast_hostile: runs random hostile cases against the promises and prints a table by generator.
//
//   oblast_hostile --cases 100000            of every generator
//   oblast_hostile --generator fans --first-seed 7 --cases 1     one case again
//
// The exit code is 1 when a case failed; failing cases are shrunk and printed as WKT.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "generators/hostile.h"
#include "generators/random.h"
#include "generators/shrink.h"
#include "generators/trial.h"
#include "generators/wkt.h"

namespace {

using namespace oblast;
using namespace oblast::generators;

struct Settings {
  std::uint64_t cases = 1000;
  std::uint64_t first_seed = 1;
  int smallest = 8;
  int largest = 60;
  int threads = 0;
  std::uint64_t show = 2;  // failures shown in full, by generator
  bool engines = false;
  double patience = 60;  // seconds
  std::string only;
};

struct Row {
  std::uint64_t cases = 0;
  std::uint64_t failed[6] = {};
  Figures figures;

  std::uint64_t failures() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t f : failed) sum += f;
    return sum;
  }
  void add(const Row& other) {
    cases += other.cases;
    for (int i = 0; i < 6; ++i) failed[i] += other.failed[i];
    figures.rounds = std::max(figures.rounds, other.figures.rounds);
    figures.displacement_ulps = std::max(figures.displacement_ulps, other.figures.displacement_ulps);
  }
};

int size_of_case(const Settings& settings, std::uint64_t seed) {
  return Random(seed ^ 0x517eu).between(settings.smallest, settings.largest);
}

std::mutex printing;

void show_failure(const HostileGenerator& generator, std::uint64_t seed, const Operands& operands,
                  const Request& request, const Failure& failure) {
  Request impatient = request;
  impatient.patience = 0.5;
  const auto fails = [&](const Operands& smaller) {
    Figures figures;
    const auto again = run_trial(smaller, impatient, figures);
    return again && again->broken == failure.broken;
  };
  const Operands small = shrink(operands, fails);
  Figures figures;
  const auto again = run_trial(small, impatient, figures);
  const Failure& shown = again ? *again : failure;
  static constexpr const char* names[] = {"intersection", "union", "difference", "symdifference"};
  const std::lock_guard lock(printing);
  fmt::print("FAILED {} seed {}: {} in {}: {}\n  {}\n  A {}\n  B {}\n", generator.name, seed, to_text(shown.broken),
             names[static_cast<int>(shown.operation)], shown.what, to_text(request), soup_to_wkt(small.a),
             soup_to_wkt(small.b));
  std::fflush(stdout);
}

void run_case(const HostileGenerator& generator, std::uint64_t seed, const Settings& settings, Row& row,
              std::atomic<std::uint64_t>& shown) {
  ++row.cases;
  Request request = draw_request(seed);
  if (settings.engines) request.other_engines = true;
  request.patience = settings.patience;
  try {
    const Operands operands = generator.make(seed, size_of_case(settings, seed));
    const auto failure = run_trial(operands, request, row.figures);
    if (!failure) return;
    ++row.failed[static_cast<int>(failure->broken)];
    if (shown++ < settings.show) show_failure(generator, seed, operands, request, *failure);
  } catch (const std::exception& e) {
    ++row.failed[static_cast<int>(Broken::threw)];
    const std::lock_guard lock(printing);
    if (shown++ < settings.show) fmt::print("FAILED {} seed {}: the generator: {}\n", generator.name, seed, e.what());
  }
}

Row run_generator(const HostileGenerator& generator, const Settings& settings) {
  Row row;
  std::mutex adding;
  std::atomic<std::uint64_t> next{0}, shown{0};
  const auto work = [&] {
    Row mine;
    for (std::uint64_t i; (i = next++) < settings.cases;) {
      run_case(generator, settings.first_seed + i, settings, mine, shown);
    }
    const std::lock_guard lock(adding);
    row.add(mine);
  };
  std::vector<std::jthread> workers;
  const int threads = settings.threads > 0 ? settings.threads : static_cast<int>(std::thread::hardware_concurrency());
  for (int t = 0; t < threads; ++t) workers.emplace_back(work);
  workers.clear();
  return row;
}

void print_row(const char* name, const Row& row) {
  fmt::print("{:<22} {:>9} {:>10} {:>14} {:>10} {:>10} {:>8} {:>6} {:>7} {:>9.2f}\n", name, row.cases, row.failed[0],
             row.failed[1], row.failed[2], row.failed[3], row.failed[4], row.failed[5], row.figures.rounds,
             row.figures.displacement_ulps);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app{"Random hostile cases against the promises, by generator"};
  app.add_option("--cases", settings.cases, "cases of every generator")->capture_default_str();
  app.add_option("--first-seed", settings.first_seed, "seeds count up from here")->capture_default_str();
  app.add_option("--smallest", settings.smallest, "edges of the smallest case")->check(CLI::Range(8, 1000000));
  app.add_option("--largest", settings.largest, "edges of the largest case")->check(CLI::Range(8, 1000000));
  app.add_option("--threads", settings.threads, "0: all cores")->capture_default_str();
  app.add_option("--generator", settings.only, "only this one");
  app.add_option("--show", settings.show, "failures shown in full, by generator")->capture_default_str();
  app.add_option("--patience", settings.patience, "seconds after which a call is given up")->capture_default_str();
  app.add_flag("--engines", settings.engines, "compare all engines in every case, not in one of four");
  CLI11_PARSE(app, argc, argv);

  fmt::print("{:<22} {:>9} {:>10} {:>14} {:>10} {:>10} {:>8} {:>6} {:>7} {:>9}\n", "generator", "cases", "unverified",
             "non-idempotent", "order-dep.", "exceptions", "engines", "areas", "rounds", "max ulps");
  Row total;
  for (const HostileGenerator& generator : hostile_generators()) {
    if (!settings.only.empty() && settings.only != generator.name) continue;
    const Row row = run_generator(generator, settings);
    print_row(generator.name, row);
    total.add(row);
  }
  print_row("all", total);
  fmt::print("{} passed, {} failed\n", total.cases - total.failures(), total.failures());
  return total.failures() == 0 && total.cases > 0 ? 0 : 1;
}
