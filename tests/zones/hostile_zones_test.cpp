// A slice of the hostile run (hostile_zones_main.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "generators/hostile_table.h"
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

// Cases of oblast_hostile_zones that failed once. In the first, a vertex on an edge of the frame is no corner of the
// row, whose edge moves as a whole; in others a row edge runs along an edge that moved, beside another row edge, or a
// region edge does so; no object has a place; a far object did not fit the domain; an arm of a polygon is thinner than
// a unit in the last place. In the last, two polygons overlap by less than that, and noding opened a gap between them.
TEST(HostileZonesKept, KeepEveryPromise) {
  const std::pair<std::string, std::uint64_t> cases[] = {
      {"integer_grid", 2554}, {"integer_grid", 61}, {"integer_grid", 89},      {"integer_grid", 2321},
      {"integer_grid", 2657}, {"fans", 1243},       {"integer_grid", 4384},    {"fans", 5026},
      {"earth_metres", 4358}, {"stars", 1601},      {"nested_squares", 117},   {"magnitudes", 193},
      {"fed_back", 238},      {"fed_back", 2186},   {"far_from_origin", 1456}, {"far_from_origin", 2239},
      {"t_junctions", 577}};
  for (const auto& [name, seed] : cases) {
    const auto all = generators::hostile_generators();
    const auto generator = std::find_if(all.begin(), all.end(), [&](const auto& g) { return g.name == name; });
    ASSERT_NE(generator, all.end()) << name;
    const int size = generators::size_of_hostile_case(seed, 40);
    const auto failure = run_zone_trial(draw_zones(generator->make(seed, size), seed), {seed, 300, false});
    EXPECT_FALSE(failure) << name << " seed " << seed << ": " << failure->what;
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
