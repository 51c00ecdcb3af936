// A slice of the hostile cases: every generator, all four operations, every promise that a trial checks; alone, with
// others far away, and in crowds. oblast_hostile runs any number of cases.
#include "generators/hostile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "generators/random.h"
#include "generators/trial.h"
#include "generators/wkt.h"
#include "properties/hostile_run.h"

namespace oblast::generators {
namespace {

class Hostile : public testing::TestWithParam<HostileGenerator> {};

std::string describe(const Operands& operands, const Request& request, std::uint64_t seed, const Failure& failure) {
  return "seed " + std::to_string(seed) + ": " + to_text(failure.broken) + ": " + failure.what + "\n" +
         to_text(request) + "\nA " + soup_to_wkt(operands.a) + "\nB " + soup_to_wkt(operands.b);
}

// Runs the cases of seeds 1 to `cases`, of `smallest` to `largest` edges, on all cores.
enum class Recompute { as_drawn, always };
void run_cases(const HostileGenerator& generator, std::uint64_t cases, int smallest, int largest,
               Recompute recompute = Recompute::as_drawn) {
  std::atomic<std::uint64_t> next{1};
  std::mutex reporting;
  const auto work = [&] {
    Figures figures;
    for (std::uint64_t seed; (seed = next++) <= cases;) {
      Request request = draw_request(seed);
      request.far = true;
      if (recompute == Recompute::always) request.recompute = true;
      const Operands operands = generator.make(seed, Random(seed).between(smallest, largest));
      if (const auto failure = run_trial(operands, request, figures)) {
        const std::lock_guard lock(reporting);
        ADD_FAILURE() << describe(operands, request, seed, *failure);
      }
    }
    const std::lock_guard lock(reporting);
    EXPECT_LE(figures.displacement_ulps, 4) << "more than a small multiple of the unit in the last place";
  };
  std::vector<std::jthread> workers;
  for (unsigned t = 0; t < std::max(1u, std::thread::hardware_concurrency()); ++t) workers.emplace_back(work);
}

TEST_P(Hostile, smallCasesKeepThePromises) { run_cases(GetParam(), 1000, 8, std::min(48, GetParam().usual)); }

// By exact rationals, one operation each: the result is the right answer, the arrangement settled, areas add up
// exactly.
TEST_P(Hostile, tinyCasesAreWhatExactArithmeticSays) { run_cases(GetParam(), 40, 8, 14, Recompute::always); }

// Large enough that the searches divide the plane, and that many edges cross the divisions.
TEST_P(Hostile, largerCasesKeepThePromises) { run_cases(GetParam(), 4, GetParam().larger / 2, GetParam().larger); }

// Each case as above, and in crowds of 950 of all generators.
TEST(HostileCrowds, casesKeepTheirBytesInCompany) {
  HostileSettings settings;
  settings.first_seed = 20001;
  settings.cases = 200;
  settings.against = false;  // oblast_hostile does this
  settings.show = 0;
  const std::vector<HostileRow> rows = run_hostile(settings, [](const FailedCase& failed) {
    ADD_FAILURE() << failed.generator->name << " "
                  << describe(failed.operands, failed.request, failed.seed, failed.failure);
  });
  EXPECT_EQ(rows.size(), hostile_generators().size());
  for (const HostileRow& row : rows) EXPECT_EQ(row.cases, settings.cases);
}

// Crossings near an axis are moved by up to 2^-301, far more than a unit in the last place of such coordinates:
// clearance that did not count this left edges that crossed.
TEST(HostileCases, magnitudesJustAboveTheLowerEndOfTheDomain) {
  const auto magnitudes = std::find_if(hostile_generators().begin(), hostile_generators().end(),
                                       [](const auto& g) { return std::string(g.name) == "magnitudes"; });
  for (const auto& [seed, size] : {std::pair<std::uint64_t, int>{55588, 50}, {43714, 60}}) {
    const Request request = draw_request(seed);
    const Operands operands = magnitudes->make(seed, size);
    Figures figures;
    const auto failure = run_trial(operands, request, figures);
    EXPECT_FALSE(failure) << describe(operands, request, seed, *failure);
    EXPECT_LE(figures.displacement_ulps, 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Generators, Hostile,
                         testing::ValuesIn(hostile_generators().begin(), hostile_generators().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace oblast::generators
