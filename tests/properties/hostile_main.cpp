// oblast_hostile: runs random hostile cases against the promises and prints a table by generator.
//
//   oblast_hostile --cases 100000            of every generator
//   oblast_hostile --generator fans --first-seed 7 --cases 1     one case again
//   oblast_hostile --cases 10000 --recompute --largest 16        the results recomputed by exact rationals
//   oblast_hostile --cases 50000 --first-seed 50001 --markdown   a later slice, as rows of a table
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
  int largest = 0;  // 0: what is usual of the generator
  int threads = 0;
  std::uint64_t show = 2;  // failures shown in full, by generator
  bool engines = false;
  bool recompute = false;
  bool markdown = false;
  double patience = 60;  // seconds
  std::string only;
};

struct Row {
  std::uint64_t cases = 0;
  std::uint64_t failed[broken_count] = {};
  Figures figures;

  std::uint64_t failures() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t f : failed) sum += f;
    return sum;
  }
  void add(const Row& other) {
    cases += other.cases;
    for (int i = 0; i < broken_count; ++i) failed[i] += other.failed[i];
    figures.rounds = std::max(figures.rounds, other.figures.rounds);
    figures.displacement_ulps = std::max(figures.displacement_ulps, other.figures.displacement_ulps);
  }
};

// Small cases more often than large ones, by the square of a number drawn evenly.
int size_of_case(const Settings& settings, const HostileGenerator& generator, std::uint64_t seed) {
  const double drawn = Random(seed ^ 0x517eu).unit();
  const int largest = settings.largest > 0 ? settings.largest : generator.usual;
  return settings.smallest + static_cast<int>(drawn * drawn * std::max(1, largest - settings.smallest + 1));
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
  if (settings.recompute) request.recompute = true;
  request.patience = settings.patience;
  try {
    const Operands operands = generator.make(seed, size_of_case(settings, generator, seed));
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

constexpr const char* columns[] = {"generator", "cases", "unverified", "non-idempotent", "order",    "exceptions",
                                   "engines",   "areas", "wrong",      "most rounds",    "most ulps"};

void print_line(const Settings& settings, const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (settings.markdown) {
      line += (i == 0 ? "| " : " ") + cells[i] + " |";
    } else {
      line += i == 0 ? fmt::format("{:<22}", cells[i]) : fmt::format(" {:>14}", cells[i]);
    }
  }
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void print_head(const Settings& settings) {
  print_line(settings, {std::begin(columns), std::end(columns)});
  if (settings.markdown) print_line(settings, std::vector<std::string>(std::size(columns), "---"));
}

void print_row(const Settings& settings, const char* name, const Row& row) {
  std::vector<std::string> cells{name, std::to_string(row.cases)};
  for (const std::uint64_t failed : row.failed) cells.push_back(std::to_string(failed));
  cells.push_back(std::to_string(row.figures.rounds));
  cells.push_back(fmt::format("{:.2f}", row.figures.displacement_ulps));
  print_line(settings, cells);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app{"Random hostile cases against the promises, by generator"};
  app.add_option("--cases", settings.cases, "cases of every generator")->capture_default_str();
  app.add_option("--first-seed", settings.first_seed, "seeds count up from here")->capture_default_str();
  app.add_option("--smallest", settings.smallest, "edges of the smallest case")->check(CLI::Range(8, 1000000));
  app.add_option("--largest", settings.largest, "edges of the largest case; 0: 60, bundles 20")
      ->check(CLI::Range(0, 1000000));
  app.add_option("--threads", settings.threads, "0: all cores")->capture_default_str();
  app.add_option("--generator", settings.only, "only this one");
  app.add_option("--show", settings.show, "failures shown in full, by generator")->capture_default_str();
  app.add_option("--patience", settings.patience, "seconds after which a call is given up")->capture_default_str();
  app.add_flag("--engines", settings.engines, "compare all engines in every case, not in one of four");
  app.add_flag("--recompute", settings.recompute, "recompute by exact rationals in every case, not in one of 256");
  app.add_flag("--markdown", settings.markdown, "rows of a table");
  CLI11_PARSE(app, argc, argv);

  print_head(settings);
  Row total;
  for (const HostileGenerator& generator : hostile_generators()) {
    if (!settings.only.empty() && settings.only != generator.name) continue;
    const Row row = run_generator(generator, settings);
    print_row(settings, generator.name, row);
    total.add(row);
  }
  print_row(settings, "all", total);
  fmt::print("{} passed, {} failed\n", total.cases - total.failures(), total.failures());
  return total.failures() == 0 && total.cases > 0 ? 0 : 1;
}
