// A slice of the hostile run (hostile_buffers_main.cpp).
#include <gtest/gtest.h>

#include "buffer/buffer_trial.h"

namespace oblast::testing {
namespace {

class HostileBuffers : public ::testing::TestWithParam<const generators::HostileGenerator*> {};

TEST_P(HostileBuffers, KeepEveryPromise) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const BufferQuestion question = draw_question(GetParam()->make(seed, 8 + static_cast<int>(seed % 20)), seed);
    const auto failure = run_buffer_trial(question, seed);
    EXPECT_FALSE(failure) << "seed " << seed << ": " << to_text(failure->broken) << ": " << failure->what << "\n  "
                          << to_text(question);
  }
}

std::vector<const generators::HostileGenerator*> all() {
  std::vector<const generators::HostileGenerator*> list;
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) list.push_back(&generator);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Generators, HostileBuffers, ::testing::ValuesIn(all()),
                         [](const auto& generator) { return generator.param->name; });

}  // namespace
}  // namespace oblast::testing
