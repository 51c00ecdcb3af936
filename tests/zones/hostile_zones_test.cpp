// A slice of the hostile run (hostile_zones_main.cpp).
#include <gtest/gtest.h>

#include "zones/zone_trial.h"

namespace oblast::testing {
namespace {

class HostileZones : public ::testing::TestWithParam<const generators::HostileGenerator*> {};

TEST_P(HostileZones, KeepEveryPromise) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    const ZoneQuestion question = draw_zones(GetParam()->make(seed, 8 + static_cast<int>(seed % 20)), seed);
    const auto failure = run_zone_trial(question, {seed, 200, false});
    EXPECT_FALSE(failure) << "seed " << seed << ": " << to_text(failure->broken) << ": " << failure->what << "\n  "
                          << to_text(question);
  }
}

std::vector<const generators::HostileGenerator*> all() {
  std::vector<const generators::HostileGenerator*> list;
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) list.push_back(&generator);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Generators, HostileZones, ::testing::ValuesIn(all()),
                         [](const auto& generator) { return generator.param->name; });

}  // namespace
}  // namespace oblast::testing
