// check_features and check_coverage: the files of tests/cases/faults, and properties on hostile input.
#include <gtest/gtest.h>
#include <oblast/check.h>
#include <oblast/check_features.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <cmath>

#include "generators/hostile.h"
#include "generators/wkt.h"
#include "verify/text_regions.h"

namespace oblast::testing {
namespace {

using enum FeatureFaultKind;
using verify::regions_of;
using Kinds = std::vector<FeatureFaultKind>;

/// For a full expression.
FeatureView view(const RegionSet& regions, std::span<const std::uint32_t> ends = {}) { return {regions, ends}; }

/// Polygons are parts of one feature.
std::vector<FeatureFault> faults_of(const RegionSet& regions) {
  const std::uint32_t ends[] = {static_cast<std::uint32_t>(regions.polygon_ends.size())};
  return check_features(view(regions, ends));
}

Kinds kinds_of(const std::vector<FeatureFault>& faults) {
  Kinds kinds;
  for (const FeatureFault& fault : faults) kinds.push_back(fault.kind);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

Kinds kinds(const std::string& text) { return kinds_of(faults_of(regions_of(text))); }

/// Each polygon is a feature.
Kinds between(const std::string& text) { return kinds_of(check_coverage(view(regions_of(text)))); }

TEST(CheckFeatures, whatIsValid) {
  EXPECT_EQ(kinds("0 0, 4 0, 4 4, 0 4"), Kinds{});
  EXPECT_EQ(kinds("0 0, 9 0, 9 9, 0 9; 1 1, 1 2, 2 2, 2 1; 2 2, 2 3, 3 3, 3 2"), Kinds{});
  // A hole touches its shell once, at a vertex and on an edge.
  EXPECT_EQ(kinds("0 0, 9 0, 9 9, 0 9; 0 0, 1 2, 2 1"), Kinds{});
  EXPECT_EQ(kinds("0 0, 9 0, 9 9, 0 9; 0 4, 1 5, 1 3"), Kinds{});
  // An island in a hole, and one that touches it in a point.
  EXPECT_EQ(kinds("0 0, 9 0, 9 9, 0 9; 1 1, 1 8, 8 8, 8 1 | 2 2, 3 2, 3 3, 2 3"), Kinds{});
  EXPECT_EQ(kinds("0 0, 9 0, 9 9, 0 9; 1 1, 1 8, 8 8, 8 1 | 1 1, 3 2, 2 3"), Kinds{});
  // Parts touch in two points: they need not be connected.
  EXPECT_EQ(kinds("0 0, 4 0, 4 4, 0 4 | 4 0, 8 2, 4 4, 7 2"), Kinds{});
  EXPECT_TRUE(check_features(view(RegionSet{})).empty());
}

TEST(CheckFeatures, placesOnBothSides) {
  const std::vector<FeatureFault> faults = faults_of(regions_of("0 0, 9 0, 9 9, 0 9 | 20 0, 24 0, 20 4, 24 4"));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].kind, ring_crosses_itself);
  EXPECT_EQ(faults[0].place, (FeaturePlace{0, 1, 3}));
  EXPECT_EQ(faults[0].other, (FeaturePlace{0, 1, 1}));
  EXPECT_EQ(faults[0].point, (Point{22, 2}));
}

TEST(CheckFeatures, allFaultsAreFound) {
  // A comb of bow-ties: every crossing is a fault of its own.
  std::string text;
  for (int i = 0; i < 50; ++i)
    text += (i ? " | " : "") + std::to_string(3 * i) + " 0, " + std::to_string(3 * i + 2) + " 2, " +
            std::to_string(3 * i + 2) + " 0, " + std::to_string(3 * i) + " 2";
  EXPECT_EQ(kinds(text), Kinds(50, ring_crosses_itself));
  // Two holes, one beside the shell and one in another hole; a part in the first part.
  EXPECT_EQ(kinds("0 0, 9 0, 9 9, 0 9; 1 1, 1 4, 4 4, 4 1; 2 2, 2 3, 3 3; 20 1, 20 2, 21 2 | 6 6, 7 6, 7 7"),
            (Kinds{hole_outside_shell, holes_overlap, parts_overlap}));
}

TEST(CheckFeatures, aStretchIsOneFault) {
  // Shell and hole run along four edges; two parts along three, with different vertices.
  EXPECT_EQ(kinds("0 0, 9 0, 9 3, 9 5, 9 7, 9 9, 0 9; 9 3, 8 4, 8 6, 9 7, 9 5"), Kinds{rings_share_edge});
  EXPECT_EQ(kinds("0 0, 4 0, 4 2, 4 4, 0 4 | 4 0, 8 0, 8 4, 4 4, 4 3, 4 1"), Kinds{parts_share_edge});
}

TEST(CheckFeatures, notes) {
  EXPECT_EQ(kinds("0 0, 4 0, 4 0, 4 4, 0 0"), (Kinds{repeated_vertex, repeated_vertex}));
  EXPECT_EQ(kinds("0 0, 0 4, 4 4"), Kinds{wrong_orientation});
  EXPECT_TRUE(is_note(repeated_vertex) && is_note(wrong_orientation) && !is_note(spike));
  for (std::size_t i = 0; i < feature_fault_kinds; ++i)
    EXPECT_NE(std::string(name(static_cast<FeatureFaultKind>(i))), "");
}

TEST(CheckFeatures, whatTheCallerKnows) {
  const RegionSet square = regions_of("0 0, 4 0, 4 4, 0 4");
  FeatureCheckOptions options;
  const std::uint32_t open[] = {0};
  options.open_contours = open;
  EXPECT_EQ(kinds_of(check_features(view(square), options)), Kinds{ring_not_closed});
  const std::uint32_t wrong[] = {1};
  options.open_contours = wrong;
  EXPECT_THROW(check_features(view(square), options), Error);
  // A record: shells first, then their holes, in a hole an island; all in one polygon.
  const RegionSet record =
      regions_of("0 0, 9 0, 9 9, 0 9; 20 0, 29 0, 29 9, 20 9; 21 1, 21 8, 28 8, 28 1; 22 2, 23 2, 23 3");
  EXPECT_EQ(kinds_of(check_features(view(record))),
            (Kinds{hole_outside_shell, holes_overlap, holes_overlap, wrong_orientation, wrong_orientation}));
  FeatureCheckOptions roleless;
  const std::uint32_t first[] = {0};
  roleless.features_without_roles = first;
  EXPECT_EQ(kinds_of(check_features(view(record), roleless)), Kinds{});
}

TEST(CheckFeatures, refusesBadArrays) {
  EXPECT_THROW(check_features(view(RegionSet{{{0, 0}, {1, 0}, {1, NAN}}, {3}, {1}})), Error);
  const RegionSet square = regions_of("0 0, 4 0, 4 4, 0 4");
  const std::uint32_t ends[] = {2};
  EXPECT_THROW(check_features(view(square, ends)), Error);
  EXPECT_THROW(check_coverage(view(square, ends)), Error);
}

TEST(CheckCoverage, kindsBetweenFeatures) {
  EXPECT_EQ(between("0 0, 4 0, 4 4, 0 4 | 4 0, 8 0, 8 4, 4 4"), Kinds{});
  EXPECT_EQ(between("0 0, 4 0, 4 4, 0 4 | 20 0, 28 0, 28 4"), Kinds{});
  EXPECT_EQ(between("0 0, 4 0, 4 4, 0 4 | 2 2, 8 2, 8 3, 2 3"), Kinds{overlap});
  // Two areas of one pair.
  EXPECT_EQ(between("0 0, 9 0, 9 4, 0 4 | 1 3, 2 3, 2 6, 6 6, 6 3, 7 3, 7 9, 1 9"), (Kinds{overlap, overlap, gap}));
  EXPECT_EQ(between("0 0, 4 0, 4 4, 0 4 | 4 2, 8 0, 8 4"), Kinds{t_junction});
  EXPECT_EQ(between("0 0, 4 0, 4 2, 4 4, 0 4 | 4 0, 8 0, 8 4, 4 4"), Kinds{mismatched_vertices});
  // The hole of one feature is no gap; filled in part, what is left is one.
  EXPECT_EQ(between("0 0, 9 0, 9 9, 0 9; 2 2, 2 6, 6 6, 6 2"), Kinds{});
  EXPECT_EQ(between("0 0, 9 0, 9 9, 0 9; 2 2, 2 6, 6 6, 6 2 | 2 2, 6 2, 6 6"), Kinds{gap});
  // Neither are two holes of it that cross; and a gap may touch the outside in points.
  EXPECT_EQ(between("0 0, 9 0, 9 9, 0 9; 1 1, 1 4, 4 4, 4 1; 3 3, 3 6, 6 6, 6 3 | 20 0, 24 0, 24 4"), Kinds{});
  EXPECT_EQ(between("0 0, 4 0, 3 2, 4 4, 0 4 | 4 0, 8 0, 8 4, 4 4"), Kinds{gap});
}

TEST(CheckCoverage, areasAndPlaces) {
  const RegionSet regions = regions_of("0 0, 9 0, 9 9, 0 9 | 3 1, 8 1, 8 3, 3 3");
  const std::vector<FeatureFault> faults = check_coverage(view(regions));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].area, 10);
  EXPECT_EQ(faults[0].place.feature, 0u);
  EXPECT_EQ(faults[0].other, (FeaturePlace{1, 1, 0}));
  // One unit in the last place is an overlap or a gap, as it is.
  const double past = std::nextafter(4.0, 5.0), short_of = std::nextafter(4.0, 3.0);
  for (const double x : {past, short_of}) {
    const RegionSet sliver{{{0, 0}, {4, 0}, {x, 2}, {4, 4}, {0, 4}, {4, 0}, {8, 0}, {8, 4}, {4, 4}}, {5, 9}, {1, 2}};
    EXPECT_EQ(kinds_of(check_coverage(view(sliver))), Kinds{x == past ? overlap : gap});
  }
}

// A result is valid in plain words, too, and threads make no difference.
class CheckFeaturesHostile : public ::testing::TestWithParam<generators::HostileGenerator> {};

TEST_P(CheckFeaturesHostile, resultsAreValidAndThreadsMakeNoDifference) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RegionSet input = GetParam().make(seed, GetParam().usual).a;
    const RegionSet result = unite(input);
    EXPECT_EQ(kinds_of(faults_of(result)), Kinds{}) << "seed " << seed;
    FeatureCheckOptions one;
    one.threads = 1;
    EXPECT_EQ(check_features(view(input), one), check_features(view(input))) << "seed " << seed;
    EXPECT_EQ(check_coverage(view(input), one), check_coverage(view(input))) << "seed " << seed;
  }
}

// Rows that do not overlap are valid features. Between them there may be gaps, and nothing else.
TEST_P(CheckFeaturesHostile, aPartitionHasNoOverlaps) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RegionSet input = GetParam().make(seed, GetParam().usual).a;
    const FeatureView features = view(input);
    const Partition parts = partition({&features, 1});
    EXPECT_EQ(kinds_of(check_features(parts.rows)), Kinds{}) << "seed " << seed;
    for (const FeatureFault& fault : check_coverage(parts.rows))
      EXPECT_EQ(fault.kind, gap) << "seed " << seed << ", at " << fault.point.x << " " << fault.point.y;
  }
}

INSTANTIATE_TEST_SUITE_P(Generators, CheckFeaturesHostile, ::testing::ValuesIn(generators::hostile_generators()),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           for (char& letter : name)
                             if (letter == ' ') letter = '_';
                           return name;
                         });

}  // namespace
}  // namespace oblast::testing
