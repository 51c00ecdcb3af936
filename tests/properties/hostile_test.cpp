// A slice of the hostile cases: every generator, all four operations, every promise a trial checks.
// oblast_hostile runs as many as one likes.
#include "generators/hostile.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "generators/random.h"
#include "generators/shrink.h"
#include "generators/trial.h"

namespace oblast::generators {
namespace {

constexpr std::uint64_t cases_by_generator = 1500;

class Hostile : public testing::TestWithParam<HostileGenerator> {};

std::string describe(const Operands& operands, const Request& request, std::uint64_t seed, const Failure& failure) {
  return "seed " + std::to_string(seed) + ": " + to_text(failure.broken) + ": " + failure.what + "\n" +
         to_text(request) + "\nA " + soup_to_wkt(operands.a) + "\nB " + soup_to_wkt(operands.b);
}

TEST_P(Hostile, casesKeepThePromises) {
  std::atomic<std::uint64_t> next{1};
  std::mutex reporting;
  const auto work = [&] {
    Figures figures;
    for (std::uint64_t seed; (seed = next++) <= cases_by_generator;) {
      const Request request = draw_request(seed);
      const Operands operands = GetParam().make(seed, Random(seed).between(8, 48));
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

INSTANTIATE_TEST_SUITE_P(Generators, Hostile,
                         testing::ValuesIn(hostile_generators().begin(), hostile_generators().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace oblast::generators
