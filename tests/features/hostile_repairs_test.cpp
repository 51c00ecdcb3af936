// A slice of the hostile run of repairs (oblast_hostile_rows --repair), in every build and setting.
#include <gtest/gtest.h>

#include "features/repair_trial.h"
#include "generators/hostile.h"

namespace oblast::testing {
namespace {

class HostileRepairs : public ::testing::TestWithParam<generators::HostileGenerator> {};

TEST_P(HostileRepairs, KeepTheirPromises) {
  const generators::HostileGenerator& generator = GetParam();
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const int size = seed % 10 == 0 ? generator.usual : 8 + static_cast<int>(seed % 12);
    const auto failure = run_repair_trial(generator.make(seed, size), seed, seed % 16 == 1);
    EXPECT_FALSE(failure) << generator.name << " seed " << seed << ": " << to_text(failure->broken) << " in "
                          << failure->operation << ": " << failure->what;
  }
}

INSTANTIATE_TEST_SUITE_P(AllGenerators, HostileRepairs,
                         ::testing::ValuesIn(generators::hostile_generators().begin(),
                                             generators::hostile_generators().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace oblast::testing
