// repair and repair_coverage on the real layers, as the program reads them.
#include <gtest/gtest.h>
#include <oblast/repair.h>

#include <algorithm>
#include <filesystem>

#include "io/rows.h"
#include "repair/layers_of.h"
#include "verify/rows.h"

namespace oblast::testing {
namespace {

struct RealLayer {
  const char* name;
  std::size_t invalid;  ///< features that GEOS calls invalid, too (shapely 2.2, GEOS 3.14)
};

constexpr RealLayer real_layers[] = {
    {"berlin-districts", 0},    {"brazil-states", 11},          {"france-communes-normandie", 1},
    {"france-departements", 0}, {"germany-counties-medium", 0}, {"germany-districts-high", 0},
    {"italy-regions", 0},       {"russia-subjects", 10}};

class RealLayers : public ::testing::TestWithParam<RealLayer> {
 protected:
  static io::Rows read() {
    const std::string path = std::string(OBLAST_SHARED) + "/realworld/" + GetParam().name + ".geojson";
    if (!std::filesystem::exists(path)) return {};
    std::vector<std::string> notes;
    return io::read_rows(std::vector{path}, {}, notes);
  }
};

TEST_P(RealLayers, HaveTheirInvalidFeaturesRepaired) {
  const io::Rows layer = read();
  if (layer.ends.empty()) GTEST_SKIP() << "no real layers at " << OBLAST_SHARED;
  const Repaired repaired = repair(layer.view());
  EXPECT_EQ(repaired.changed.size(), GetParam().invalid);
  std::size_t next = 0;
  for (std::uint32_t f = 0; f < layer.ends.size(); ++f) {
    if (next < repaired.changed.size() && repaired.changed[next].feature == f) {
      const auto fault = verify::check_result(verify::regions_of(repaired.features, f));
      EXPECT_FALSE(fault) << fault->what;
      ++next;
      continue;
    }
    const RegionView before = verify::regions_of(layer.view(), f), now = verify::regions_of(repaired.features, f);
    ASSERT_TRUE(std::equal(before.points.begin(), before.points.end(), now.points.begin(), now.points.end())) << f;
  }
  const Repaired again = repair(repaired.features);
  EXPECT_TRUE(again.changed.empty());
  EXPECT_EQ(again.features, repaired.features);
}

TEST_P(RealLayers, BecomeCoverages) {
  const io::Rows layer = read();
  if (layer.ends.empty()) GTEST_SKIP() << "no real layers at " << OBLAST_SHARED;
  CoverageRepairOptions options;
  options.overlaps = OverlapRule::largest;
  options.gaps_narrower = 1e-4;
  options.slivers_narrower = 1e-5;
  const RepairedCoverage repaired = repair_coverage(layer.view(), options);
  const FeatureSet canonical = canonical_rows(repaired.features);
  const auto fault = verify::check_rows(canonical);
  EXPECT_FALSE(fault) << fault->what;
  EXPECT_EQ(canonical.regions.points.size(), repaired.features.regions.points.size());
  const RepairedCoverage again = repair_coverage(repaired.features, options);
  EXPECT_TRUE(again.changes.empty());
  EXPECT_EQ(again.features, repaired.features);
  EXPECT_EQ(again.gaps_left, repaired.gaps_left);
}

INSTANTIATE_TEST_SUITE_P(All, RealLayers, ::testing::ValuesIn(real_layers), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace oblast::testing
