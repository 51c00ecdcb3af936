// repair_coverage: to whom overlaps, gaps and slivers go, and what stays as it is.
#include <gtest/gtest.h>
#include <oblast/repair.h>

#include <cmath>
#include <limits>

#include "repair/exact_sum.h"
#include "repair/layers_of.h"

namespace oblast::testing {
namespace {

using Texts = std::vector<std::string>;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string square(double x0, double y0, double x1, double y1) {
  return to_wkt(RegionSet{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}});
}

/// The repaired rows, proved to be a coverage; repaired again they stay.
RepairedCoverage repaired(const TextLayer& layer, const CoverageRepairOptions& options = {}) {
  RepairedCoverage result = repair_coverage(layer, options);
  EXPECT_EQ(result.features.size(), layer.ends.size());
  const FeatureSet canonical = canonical_rows(result.features);
  const auto fault = verify::check_rows(canonical);
  EXPECT_FALSE(fault) << fault->what;
  const RepairedCoverage again = repair_coverage(result.features, options);
  EXPECT_EQ(again.features, result.features);
  EXPECT_TRUE(again.changes.empty());
  EXPECT_TRUE(again.changed.empty());
  return result;
}

TEST(RepairCoverage, GivesAnOverlapToTheFirst) {
  const TextLayer layer({square(0, 0, 4, 4), square(3, 0, 9, 4)});
  const RepairedCoverage result = repaired(layer);
  EXPECT_EQ(result.changes, (std::vector<CoverageRepair>{{CoverageChange::overlap, {1}, 0, 4, {3, 0}}}));
  // The first one gets no vertex of the border that is gone.
  EXPECT_EQ(texts_of(result.features)[1], "POLYGON ((4 0, 9 0, 9 4, 4 4, 4 0))");
}

TEST(RepairCoverage, GivesAnOverlapToTheLargest) {
  const TextLayer layer({square(0, 0, 4, 4), square(3, 0, 9, 4), square(100, 0, 101, 1)});
  CoverageRepairOptions options;
  options.overlaps = OverlapRule::largest;
  const RepairedCoverage result = repaired(layer, options);
  EXPECT_EQ(result.changes, (std::vector<CoverageRepair>{{CoverageChange::overlap, {0}, 1, 4, {3, 0}}}));
  EXPECT_EQ(text_of(result.features, 0), "POLYGON ((0 0, 3 0, 3 4, 0 4, 0 0))");
  EXPECT_EQ(text_of(result.features, 2), text_of(layer, 2));
}

TEST(RepairCoverage, OfTwoEquallyLargeTheFirstCounts) {
  const TextLayer layer({square(5, 0, 9, 4), square(3, 0, 7, 4)});
  CoverageRepairOptions options;
  options.overlaps = OverlapRule::largest;
  EXPECT_EQ(repaired(layer, options).changes[0].to, 0U);
}

TEST(RepairCoverage, ComparesAreasExactly) {
  // The second is larger by 2^-52 of its area: less than a sum of doubles around 1e9 shows.
  const double more = std::nextafter(1e9 + 4, 2e9);
  const TextLayer layer({square(1e9, 0, 1e9 + 4, 4), square(1e9, 0, more, 4)});
  CoverageRepairOptions options;
  options.overlaps = OverlapRule::largest;
  const RepairedCoverage result = repaired(layer, options);
  EXPECT_EQ(result.changes[0].to, 1U);
  EXPECT_EQ(text_of(result.features, 0), "MULTIPOLYGON EMPTY");
}

TEST(RepairCoverage, GivesACrowdToOne) {
  const TextLayer layer({square(0, 0, 4, 4), square(2, 0, 6, 4), square(1, 0, 5, 4), square(1, 0, 5, 4)});
  const RepairedCoverage result = repaired(layer);
  EXPECT_EQ(text_of(result.features, 3), "MULTIPOLYGON EMPTY");
  EXPECT_EQ(text_of(result.features, 2), "MULTIPOLYGON EMPTY");
  for (const CoverageRepair& change : result.changes)
    EXPECT_TRUE(std::is_sorted(change.from.begin(), change.from.end()));
  EXPECT_EQ(result.changes.size(), 3U);  // 1 to 2, 2 to 4, 4 to 5
}

// Two squares and two bars around a square that nobody has.
TextLayer with_gap() {
  return TextLayer({square(0, 0, 1, 1), square(2, 0, 3, 1), square(0, 1, 3, 2), square(0, -1, 3, 0)});
}

TEST(RepairCoverage, LeavesGapsIfNothingIsAsked) {
  const RepairedCoverage result = repaired(with_gap());
  EXPECT_TRUE(result.changes.empty());
  EXPECT_EQ(result.gaps_left, 1U);
}

TEST(RepairCoverage, ClosesGapsBelowAnArea) {
  CoverageRepairOptions options;
  options.gaps_below = 1;
  EXPECT_EQ(repaired(with_gap(), options).gaps_left, 1U);  // the gap has just this area
  options.gaps_below = std::nextafter(1, 2);
  const RepairedCoverage result = repaired(with_gap(), options);
  // All four borders are of length 1: the first feature.
  EXPECT_EQ(result.changes, (std::vector<CoverageRepair>{{CoverageChange::gap, {}, 0, 1, {1, 0}}}));
  EXPECT_EQ(result.gaps_left, 0U);
}

TEST(RepairCoverage, ClosesGapsNarrowerThanAWidth) {
  // 10 by 1: twice the area by the perimeter is 20/22.
  const TextLayer layer({square(0, 0, 10, 3), square(-1, 3, 0, 4), square(10, 3, 11, 4), square(0, 4, 10, 7)});
  CoverageRepairOptions options;
  options.gaps_narrower = 0.9;
  EXPECT_EQ(repaired(layer, options).gaps_left, 1U);  // enclosed, though the pieces around only touch at points
  options.gaps_narrower = 0.91;
  const RepairedCoverage result = repaired(layer, options);
  ASSERT_EQ(result.changes.size(), 1U);
  EXPECT_EQ(result.changes[0].to, 0U);
}

TEST(RepairCoverage, GivesAGapToTheLongestBorder) {
  // A border of 3 in two edges is longer than one of 2.
  const TextLayer layer({"POLYGON ((0 0, 0 -1, 6 -1, 6 0, 0 0))", "POLYGON ((-1 0, 0 0, 0 3, 6 3, 6 5, -1 5, -1 0))",
                         square(6, 0, 7, 3)});
  CoverageRepairOptions options;
  options.gaps_below = infinity;
  const RepairedCoverage result = repaired(layer, options);
  ASSERT_EQ(result.changes.size(), 1U);
  EXPECT_EQ(result.changes[0].to, 1U);  // 3 + 6 against 6 and 3
}

TEST(RepairCoverage, ClosesAGapWithAnIsland) {
  const TextLayer layer({"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1))", square(3, 3, 5, 5)});
  CoverageRepairOptions options;
  options.gaps_below = 46;
  const RepairedCoverage result = repaired(layer, options);
  EXPECT_EQ(result.changes, (std::vector<CoverageRepair>{{CoverageChange::gap, {}, 0, 45, {1, 1}}}));
  EXPECT_EQ(text_of(result.features, 0), "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 5, 5 5, 5 3, 3 3))");
}

TEST(RepairCoverage, MovesSliversToTheLongestBorder) {
  // The second feature has a part of 1 x 0.1 between the first and the third.
  const TextLayer layer({square(0, 0, 5, 1),
                         "MULTIPOLYGON (((9 9, 12 9, 12 12, 9 12, 9 9)), ((0 1, 1 1, 1 1.125, 0 1.125, 0 1)))",
                         "POLYGON ((0 1.125, 1 1.125, 1 1, 5 1, 5 2, 0 2, 0 1.125))"});
  CoverageRepairOptions options;
  options.slivers_below = 0.125;
  EXPECT_TRUE(repaired(layer, options).changes.empty());
  options.slivers_below = 0.126;
  const RepairedCoverage result = repaired(layer, options);
  EXPECT_EQ(result.changes, (std::vector<CoverageRepair>{{CoverageChange::sliver, {1}, 2, 0.125, {0, 1}}}));
  options.slivers_below = 0;
  options.slivers_narrower = 0.12;
  EXPECT_EQ(repaired(layer, options).changes, result.changes);
}

TEST(RepairCoverage, KeepsTheLargestPartAndIslands) {
  const TextLayer layer(
      {square(0, 0, 1, 1), "MULTIPOLYGON (((1 0, 2 0, 2 1, 1 1, 1 0)), ((7 7, 8 7, 8 7.5, 7 7.5, 7 7)))"});
  CoverageRepairOptions options;
  options.slivers_below = infinity;
  const RepairedCoverage result = repaired(layer, options);
  EXPECT_TRUE(result.changes.empty());
  EXPECT_EQ(texts_of(result.features), texts_of(layer));
}

TEST(RepairCoverage, MovesChainsOfSliversInWaves) {
  // Ten slivers in a row behind each other; only the first one touches a part that stays.
  Texts features{square(0, 0, 1, 1)};
  for (int i = 0; i < 10; ++i) {
    const RegionSet parts = [&] {
      const double x = 1 + i / 8.0, y = 50 + 10 * i;
      return RegionSet{
          {{x, 0}, {x + 0.125, 0}, {x + 0.125, 1}, {x, 1}, {50, y}, {52, y}, {52, y + 2}, {50, y + 2}}, {4, 8}, {1, 2}};
    }();
    features.push_back(to_wkt(parts));
  }
  CoverageRepairOptions options;
  options.slivers_below = 1;
  const RepairedCoverage result = repaired(TextLayer(features), options);
  EXPECT_EQ(result.changes.size(), 10U);
  for (const CoverageRepair& change : result.changes) EXPECT_EQ(change.to, 0U);
}

TEST(RepairCoverage, PutsVerticesOfNeighboursIn) {
  const TextLayer layer({square(0, 0, 4, 4), square(4, 0, 8, 2), square(4, 2, 8, 4), "POLYGON ((9 9, 9 8, 8 8, 9 9))"});
  const RepairedCoverage result = repaired(layer);
  EXPECT_TRUE(result.changes.empty());
  EXPECT_EQ(result.changed, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(texts_of(result.features), (Texts{"POLYGON ((0 0, 4 0, 4 2, 4 4, 0 4, 0 0))", text_of(layer, 1),
                                              text_of(layer, 2), text_of(layer, 3)}));
}

TEST(RepairCoverage, RepairsFeaturesThatAreNotValid) {
  const TextLayer layer({"POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))", square(20, 0, 21, 1)});
  const RepairedCoverage result = repaired(layer);
  EXPECT_EQ(result.changed, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(text_of(result.features, 0), "MULTIPOLYGON (((0 0, 2 2, 0 4, 0 0)), ((2 2, 4 0, 4 4, 2 2)))");
}

TEST(RepairCoverage, TakesNoFeatures) {
  const RepairedCoverage result = repair_coverage({});
  EXPECT_EQ(result.features, FeatureSet{});
  EXPECT_TRUE(repair({}).changed.empty());
}

TEST(RepairCoverage, RefusesBadBounds) {
  for (const double bound : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    for (double CoverageRepairOptions::*const member :
         {&CoverageRepairOptions::gaps_below, &CoverageRepairOptions::gaps_narrower,
          &CoverageRepairOptions::slivers_below, &CoverageRepairOptions::slivers_narrower}) {
      CoverageRepairOptions options;
      options.*member = bound;
      try {
        repair_coverage({}, options);
        FAIL();
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_option);
      }
    }
  }
  CoverageRepairOptions options;
  options.overlaps = static_cast<OverlapRule>(2);
  EXPECT_THROW(repair_coverage({}, options), Error);
}

TEST(ExactSum, CancelsToTheLastBit) {
  using internal::repairing::ExactSum;
  ExactSum sum;
  sum.add_product(1e150, 1e150);
  sum.add(1e-200);
  sum.add_product(3, 1e-90);
  sum.compress();
  sum.add_product(-1e150, 1e150);
  sum.add_product(-3, 1e-90);
  EXPECT_EQ(sum.estimate(), 1e-200);
  EXPECT_EQ(sum.sign(), 1);
  sum.add(-1e-200);
  EXPECT_EQ(sum.sign(), 0);
}

}  // namespace
}  // namespace oblast::testing
