// oblast_hostile: runs random hostile cases against the promises and prints a table by generator.
//
//   oblast_hostile --cases 100000            of every generator
//   oblast_hostile --generator fans --first-seed 7 --cases 1     one case again, alone and with others far away
//   oblast_hostile --cases 10000 --recompute --largest 16        every arrangement recomputed by exact integers
//   oblast_hostile --cases 50000 --first-seed 50001 --markdown   a later slice, as rows of a table
//
// Each case is judged alone, with others far away, and in a crowd of about 950 cases of all generators side by side:
// the cases of 50 consecutive seeds. A failure in a crowd names the seed of the crowd. This runs the crowd again:
//   oblast_hostile --first-seed SEED --cases 50
//
// The exit code is 1 if a case failed. Failing cases are made smaller and printed as WKT.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <map>

#include "generators/company.h"
#include "generators/shrink.h"
#include "generators/wkt.h"
#include "properties/hostile_run.h"

namespace {

using namespace oblast;
using namespace oblast::generators;

void show_crowd(const FailedCase& failed) {
  fmt::print("FAILED {} seed {}: {}: {}\n", failed.generator->name, failed.seed, to_text(failed.failure.broken),
             failed.failure.what);
}

constexpr const char* operations[] = {"intersection", "union", "difference", "symdifference"};

void show_operands(const FailedCase& failed, const Failure& failure, const Operands& operands) {
  fmt::print("FAILED {} seed {}: {} in {}: {}\n  {}\n  A {}\n  B {}\n", failed.generator->name, failed.seed,
             to_text(failure.broken), operations[static_cast<int>(failure.operation)], failure.what,
             to_text(failed.request), soup_to_wkt(operands.a), soup_to_wkt(operands.b));
}

// The case and the squares together, while their overlay differs from the overlays of the connected parts.
void show_far(const FailedCase& failed) {
  const Options options = options_of(failed.request);
  const auto fails = [&](const Operands& o) { return !is_local(o, failed.failure.operation, options); };
  Operands all = with_others_far_away(failed.operands, failed.request);
  if (fails(all)) all = shrink(std::move(all), fails);
  show_operands(failed, failed.failure, all);
}

void show_failure(const FailedCase& failed) {
  Request impatient = failed.request;
  impatient.patience = 0.5;
  const auto fails = [&](const Operands& smaller) {
    Figures figures;
    const auto again = run_trial(smaller, impatient, figures);
    return again && again->broken == failed.failure.broken;
  };
  const Operands small = fails(failed.operands) ? shrink(failed.operands, fails) : failed.operands;
  Figures figures;
  const auto again = run_trial(small, impatient, figures);
  show_operands(failed, again ? *again : failed.failure, small);
}

constexpr const char* columns[] = {"generator", "cases",       "unverified", "non-idempotent", "order",
                                   "far",       "crowd",       "exceptions", "engines",        "areas",
                                   "wrong",     "most rounds", "most ulps"};

void print_line(bool markdown, const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (markdown) {
      line += (i == 0 ? "| " : " ") + cells[i] + " |";
    } else {
      line += i == 0 ? fmt::format("{:<22}", cells[i]) : fmt::format(" {:>14}", cells[i]);
    }
  }
  fmt::print("{}\n", line);
}

void print_row(bool markdown, const char* name, const HostileRow& row) {
  std::vector<std::string> cells{name, std::to_string(row.cases)};
  for (const std::uint64_t failed : row.failed) cells.push_back(std::to_string(failed));
  cells.push_back(std::to_string(row.figures.rounds));
  cells.push_back(fmt::format("{:.2f}", row.figures.displacement_ulps));
  print_line(markdown, cells);
}

}  // namespace

int main(int argc, char** argv) {
  HostileSettings settings;
  bool markdown = false;
  CLI::App app{"Random hostile cases against the promises, by generator"};
  app.add_option("--cases", settings.cases, "cases of every generator")->capture_default_str();
  app.add_option("--first-seed", settings.first_seed, "seeds count up from here")->capture_default_str();
  app.add_option("--smallest", settings.smallest, "edges of the smallest case")->check(CLI::Range(8, 1000000));
  app.add_option("--largest", settings.largest, "edges of the largest case; 0: 60, bundles 20")
      ->check(CLI::Range(0, 1000000));
  app.add_option("--large", settings.large, "one of so many cases has up to thousands of edges; 0: none")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "0: all cores")->capture_default_str();
  app.add_option("--generator", settings.only, "only this one");
  app.add_option("--show", settings.show, "failures shown in full, by generator")->capture_default_str();
  app.add_option("--patience", settings.patience, "seconds after which a call is given up and counts as an exception");
  app.add_flag("--engines", settings.engines, "compare all engines in every case, not in one of four");
  app.add_flag("--recompute", settings.recompute, "recompute the arrangement in every case, not in one of 256");
  app.add_flag("--markdown", markdown, "rows of a table");
  CLI11_PARSE(app, argc, argv);

  std::map<std::pair<const HostileGenerator*, bool>, std::uint64_t> shown;
  const std::vector<HostileRow> rows = run_hostile(settings, [&](const FailedCase& failed) {
    const bool crowd = failed.failure.broken == Broken::crowd;
    if (shown[{failed.generator, crowd}]++ >= settings.show) return;
    if (crowd) show_crowd(failed);
    if (failed.failure.broken == Broken::far) show_far(failed);
    if (!crowd && failed.failure.broken != Broken::far) show_failure(failed);
    std::fflush(stdout);
  });
  print_line(markdown, {std::begin(columns), std::end(columns)});
  if (markdown) print_line(markdown, std::vector<std::string>(std::size(columns), "---"));
  HostileRow total;
  for (const HostileRow& row : rows) {
    print_row(markdown, row.generator->name, row);
    total.add(row);
  }
  print_row(markdown, "all", total);
  // A case may fail alone and again in a crowd.
  fmt::print("{} cases, {} failures\n", total.cases, total.failures());
  return total.failures() == 0 && total.cases > 0 ? 0 : 1;
}
