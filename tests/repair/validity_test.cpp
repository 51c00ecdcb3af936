// Whether a feature is valid is decided in one place, from its edges. Here it is compared with another way, by the
// region that the feature means: a valid feature has exactly the rings of its region.
#include <gtest/gtest.h>
#include <oblast/oblast.h>

#include "check/valid_feature.h"
#include "generators/hostile.h"
#include "repair/feature_regions.h"
#include "repair/same_region.h"

namespace oblast::internal {
namespace {

struct Count {
  std::size_t valid = 0, all = 0;
};

void compare(const FeatureView& features, Count& count) {
  const Repaired repaired = repair(features);
  std::size_t changed = 0;
  for (std::uint32_t f = 0; f < features.feature_count(); ++f) {
    const RegionView alone = repairing::feature_regions(features, f);
    if (alone.points.empty()) continue;
    const bool valid = checking::is_valid_feature({features, f});
    const RegionSet region = unite(alone);
    EXPECT_EQ(valid, repairing::is_same_region(alone, region, repairing::MoreVertices::allowed)) << to_wkt(alone);
    const bool is_changed = changed < repaired.changed.size() && repaired.changed[changed].feature == f;
    changed += is_changed;
    EXPECT_EQ(valid, !is_changed) << to_wkt(alone);
    count.valid += valid;
    ++count.all;
  }
}

// Features of one, two or three polygons each.
std::vector<std::uint32_t> ends_of(const RegionSet& regions, std::uint64_t seed) {
  std::vector<std::uint32_t> ends;
  const auto polygons = static_cast<std::uint32_t>(regions.polygon_ends.size());
  for (std::uint32_t end = 0; end < polygons;) {
    end = std::min(polygons, end + 1 + static_cast<std::uint32_t>((seed + end) % 3));
    ends.push_back(end);
  }
  return ends;
}

TEST(ValidFeature, IsWhatItsRegionSays) {
  Count count;
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    SCOPED_TRACE(generator.name);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const generators::Operands operands = generator.make(seed, generator.usual);
      const RegionSet both = overlay(operands.a, operands.b, Operation::symmetric_difference);
      for (const RegionSet* given : {&operands.a, &operands.b, &both}) {
        const std::vector<std::uint32_t> ends = ends_of(*given, seed);
        compare({*given, ends}, count);
      }
    }
  }
  EXPECT_GT(count.valid, count.all / 10);
  EXPECT_GT(count.all - count.valid, count.all / 10);
}

}  // namespace
}  // namespace oblast::internal
