// A call is stopped at any moment: its progress function returns false or throws. The call throws, does not call the
// function again, leaks nothing, and the next call is right.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <atomic>

#include "faults/allocations.h"
#include "faults/inputs.h"
#include "generators/hostile.h"
#include "generators/random.h"

namespace oblast::testing {
namespace {

/// Cancels when the progress function is called for the `last`-th time. False if the call ended before.
bool is_cancelled(const generators::Operands& operands, Operation operation, Options options, int last,
                  const RegionSet& expected) {
  std::atomic<int> asked = 0;
  options.progress = [&](Stage, double) { return ++asked < last; };
  try {
    EXPECT_EQ(overlay(operands.a, operands.b, operation, options), expected);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
    EXPECT_EQ(asked, last) << "asked again after the answer was to stop";
    return true;
  }
  EXPECT_LT(asked, last);
  return false;
}

/// An exception that no library throws.
struct Thrown {
  explicit Thrown(int number) : value(number) {}
  Thrown(const Thrown&) = delete;
  Thrown& operator=(const Thrown&) = delete;
  int value;
};

/// Throws when the progress function is called for the `last`-th time.
bool is_thrown_out(const generators::Operands& operands, Operation operation, Options options, int last,
                   const RegionSet& expected) {
  std::atomic<int> asked = 0;
  const auto thrown = [&] {
    try {
      throw Thrown(last);
    } catch (...) {
      return std::current_exception();
    }
  }();
  options.progress = [&](Stage, double) {
    if (++asked == last) std::rethrow_exception(thrown);
    return true;
  };
  try {
    EXPECT_EQ(overlay(operands.a, operands.b, operation, options), expected);
  } catch (const Thrown& caught) {
    EXPECT_EQ(caught.value, last);
    EXPECT_EQ(std::current_exception(), thrown) << "another exception than the caller's";
    EXPECT_EQ(asked, last) << "asked again after it threw";
    return true;
  }
  EXPECT_LT(asked, last);
  return false;
}

constexpr Operation operations[] = {Operation::unite, Operation::intersection, Operation::difference,
                                    Operation::symmetric_difference};

class Cancelled : public ::testing::TestWithParam<Engine> {};

TEST_P(Cancelled, atAnyQuestionThrowsAndLeaksNothing) {
  const generators::Operands operands = generators::coverages(2, 20000);
  for (const int threads : {1, 2, 8}) {
    Options options;
    options.engine = GetParam();
    options.threads = threads;
    const RegionSet expected = overlay(operands.a, operands.b, Operation::unite, options);
    const std::int64_t before = live_blocks();
    int last = 1;
    while (last < 300 && is_cancelled(operands, Operation::unite, options, last, expected)) ++last;
    EXPECT_GT(last, 2) << "asked too seldom to be stopped promptly";
    EXPECT_EQ(live_blocks(), before) << threads << " threads";
  }
}

TEST_P(Cancelled, atRandomQuestionsOnInputsAboveEveryThreshold) {
  generators::Random random(3);
  std::size_t next_operation = 0;
  for (const auto& [name, operands] : threshold_inputs(usual_scale)) {
    for (const int threads : {1, 2, 8}) {
      const Operation operation = operations[next_operation++ % std::size(operations)];
      SCOPED_TRACE(name + ", operation " + std::to_string(static_cast<int>(operation)) + ", " +
                   std::to_string(threads) + " threads");
      Options options;
      options.engine = GetParam();
      options.threads = threads;
      const RegionSet expected = overlay(operands.a, operands.b, operation, options);
      const std::int64_t before = live_blocks();
      int questions = 0;
      options.progress = [&](Stage, double) { return ++questions, true; };
      overlay(operands.a, operands.b, operation, options);
      int ended = 0;
      for (int trial = 0; trial < 3; ++trial) {
        ended += is_cancelled(operands, operation, options, 1 + random.below(questions), expected);
        ended += is_thrown_out(operands, operation, options, 1 + random.below(questions), expected);
      }
      EXPECT_TRUE(is_cancelled(operands, operation, options, 1, expected));
      EXPECT_TRUE(is_thrown_out(operands, operation, options, 1, expected));
      EXPECT_EQ(live_blocks(), before);
    }
  }
}

constexpr Engine engines[] = {Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov};
constexpr const char* engine_names[] = {"leonov_nikitin", "vatti", "skvortsov"};
INSTANTIATE_TEST_SUITE_P(Engines, Cancelled, ::testing::ValuesIn(engines),
                         [](const auto& tested) { return engine_names[static_cast<int>(tested.param)]; });

}  // namespace
}  // namespace oblast::testing
