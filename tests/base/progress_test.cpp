// Progress: one fraction for the whole call, that grows at every question and is 1 at the last one only.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include <atomic>

#include "generators/hostile.h"

namespace oblast::internal {
namespace {

struct Asked {
  double last = -1;
  int questions = 0;
};

Asked ask(const generators::Operands& operands, Operation operation, Options options) {
  Asked asked;
  std::atomic<int> asking = 0;
  options.progress = [&](Stage, double fraction) {
    EXPECT_EQ(++asking, 1) << "two questions at a time";
    EXPECT_GT(fraction, asked.last);
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    EXPECT_LT(asked.last, 1) << "asked again after all was done";
    asked.last = fraction;
    ++asked.questions;
    --asking;
    return true;
  };
  overlay(operands.a, operands.b, operation, options);
  return asked;
}

class Progresses : public ::testing::TestWithParam<Engine> {};

TEST_P(Progresses, fromNothingToAll) {
  for (const int threads : {1, 2, 8}) {
    for (const int size : {8, 200, 20000}) {
      for (const auto& operands : {generators::coverages(2, size), generators::checkerboards(3, size)}) {
        Options options;
        options.engine = GetParam();
        options.threads = threads;
        for (const Operation operation : {Operation::unite, Operation::intersection}) {
          const Asked asked = ask(operands, operation, options);
          EXPECT_EQ(asked.last, 1) << size << ", " << threads << " threads";
          EXPECT_GT(asked.questions, 0);
        }
      }
    }
  }
}

constexpr Engine engines[] = {Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov};
constexpr const char* engine_names[] = {"leonov_nikitin", "vatti", "skvortsov"};
INSTANTIATE_TEST_SUITE_P(Engines, Progresses, ::testing::ValuesIn(engines),
                         [](const auto& tested) { return engine_names[static_cast<int>(tested.param)]; });

}  // namespace
}  // namespace oblast::internal
