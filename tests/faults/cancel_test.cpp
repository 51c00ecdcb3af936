// A call cancelled at any moment it asks: it throws, asks no more, and leaks nothing.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <atomic>

#include "faults/allocations.h"
#include "generators/hostile.h"

namespace oblast::testing {
namespace {

/// Cancels at the `last`-th question. False when the call had its answer before.
bool is_cancelled(const generators::Operands& operands, Options options, int last) {
  std::atomic<int> asked = 0;
  options.progress = [&](Stage, double) { return ++asked < last; };
  try {
    overlay(operands.a, operands.b, Operation::unite, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
    EXPECT_EQ(asked, last) << "asked again after the answer was to stop";
    return true;
  }
  EXPECT_LT(asked, last);
  return false;
}

class Cancelled : public ::testing::TestWithParam<Engine> {};

TEST_P(Cancelled, atAnyQuestionThrowsAndLeaksNothing) {
  const generators::Operands operands = generators::coverages(2, 20000);
  for (const int threads : {1, 2}) {
    Options options;
    options.engine = GetParam();
    options.threads = threads;
    overlay(operands.a, operands.b, Operation::unite, options);
    const std::int64_t before = live_blocks();
    int last = 1;
    while (last < 1000 && is_cancelled(operands, options, last)) ++last;
    EXPECT_GT(last, 5) << "asked too seldom to be stopped promptly";
    EXPECT_EQ(live_blocks(), before) << threads << " threads";
  }
}

constexpr Engine engines[] = {Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov};
constexpr const char* engine_names[] = {"leonov_nikitin", "vatti", "skvortsov"};
INSTANTIATE_TEST_SUITE_P(Engines, Cancelled, ::testing::ValuesIn(engines),
                         [](const auto& tested) { return engine_names[static_cast<int>(tested.param)]; });

}  // namespace
}  // namespace oblast::testing
