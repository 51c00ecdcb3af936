// repair: each kind of fault, valid features in any form, and what the report says.
#include <gtest/gtest.h>
#include <oblast/repair.h>

#include <cmath>
#include <limits>

#include "repair/layers_of.h"
#include "support/same_bits.h"

namespace oblast::testing {
namespace {

using Faults = std::vector<RepairFault>;

struct FaultCase {
  const char* name;
  const char* feature;
  Faults faults;
  double removed, added, after;
};

std::vector<FaultCase> fault_cases() {
  using enum RepairFault;
  return {
      {"bowtie", "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))", {ring_crosses_itself}, 0, 0, 8},
      {"spike", "POLYGON ((0 0, 4 0, 4 2, 9 2, 4 2, 4 4, 0 4, 0 0))", {spike}, 0, 0, 16},
      {"spike_inwards", "POLYGON ((0 0, 4 0, 4 2, 1 2, 4 2, 4 4, 0 4, 0 0))", {spike}, 0, 0, 16},
      {"ring_wound_twice", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0, 4 0, 4 4, 0 4, 0 0))", {ring_repeats_border}, 16, 0, 0},
      {"inner_loop", "POLYGON ((0 0, 9 0, 9 9, 2 9, 2 3, 6 3, 6 6, 0 6, 0 0))", {ring_crosses_itself}, 12, 0, 63},
      {"eight", "POLYGON ((0 0, 2 2, 4 0, 4 4, 2 2, 0 4, 0 0))", {ring_meets_itself}, 0, 0, 8},
      {"vertex_on_own_edge", "POLYGON ((0 0, 4 0, 4 4, 2 0, 0 4, 0 0))", {ring_meets_itself}, 0, 0, 8},
      {"hole_outside", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (6 0, 8 0, 8 2, 6 2, 6 0))", {hole_outside}, 0, 4, 20},
      {"hole_half_outside",
       "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (3 1, 6 1, 6 3, 3 3, 3 1))",
       {rings_cross, hole_outside},
       0,
       4,
       18},
      {"hole_in_hole",
       "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1), (3 3, 5 3, 5 5, 3 5, 3 3))",
       {holes_overlap},
       0,
       4,
       36},
      {"holes_overlap",
       "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 4 1, 4 4, 1 4, 1 1), (3 3, 6 3, 6 6, 3 6, 3 3))",
       {rings_cross, holes_overlap},
       0,
       1,
       65},
      {"hole_shares_border",
       "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 0, 3 0, 3 2, 1 2, 1 0))",
       {rings_share_border},
       0,
       0,
       12},
      {"holes_share_border",
       "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 3 1, 3 3, 1 3, 1 1), (3 1, 5 1, 5 3, 3 3, 3 1))",
       {rings_share_border},
       0,
       0,
       73},
      {"ring_given_twice",
       "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (0 0, 4 0, 4 4, 0 4, 0 0))",
       {rings_share_border},
       0,
       0,
       0},
      {"hole_given_twice",
       "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 3 1, 3 3, 1 3, 1 1), (1 1, 3 1, 3 3, 1 3, 1 1))",
       {rings_share_border, holes_overlap},
       0,
       4,
       81},
      {"interior_parted",
       "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (4 0, 6 4, 4 8, 2 4, 4 0))",
       {interior_parted},
       0,
       0,
       48},
      {"nested_shells",
       "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((1 1, 3 1, 3 3, 1 3, 1 1)))",
       {polygons_overlap},
       0,
       0,
       81},
      {"overlapping_polygons",
       "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((2 2, 6 2, 6 6, 2 6, 2 2)))",
       {polygons_overlap},
       0,
       0,
       28},
      {"polygons_share_border",
       "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((4 0, 8 0, 8 4, 4 4, 4 0)))",
       {polygons_share_border},
       0,
       0,
       32},
      {"same_polygon_twice",
       "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((0 4, 4 4, 4 0, 0 0, 0 4)))",
       {polygons_overlap, polygons_share_border},
       0,
       0,
       16},
      {"two_points", "POLYGON ((0 0, 4 0, 0 0))", {too_few_points}, 0, 0, 0},
      {"flat", "POLYGON ((0 0, 4 0, 2 0, 0 0))", {no_area}, 0, 0, 0},
      {"flat_hole", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 2, 3 3, 1 1))", {no_area}, 0, 0, 16},
      {"hole_alone_is_two_points", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 2, 1 1))", {too_few_points}, 0, 0, 16},
  };
}

class RepairFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(RepairFaults, AreNamedAndRepaired) {
  const FaultCase& fault = GetParam();
  const TextLayer layer({"POLYGON ((20 0, 21 0, 20 1, 20 0))", fault.feature});
  const Repaired repaired = repair(layer);
  ASSERT_EQ(repaired.changed.size(), 1U);
  const FeatureRepair& report = repaired.changed[0];
  EXPECT_EQ(report.feature, 1U);
  EXPECT_EQ(report.faults, fault.faults) << to_text(report.faults[0]);
  EXPECT_EQ(report.area_removed, fault.removed);
  EXPECT_EQ(report.area_added, fault.added);
  EXPECT_EQ(report.area_after, fault.after);
  const RegionView feature = verify::regions_of(repaired.features, 1);
  EXPECT_EQ(feature.points.empty() ? 0 : signed_area(feature), fault.after);
  EXPECT_EQ(report.rings_before, verify::regions_of(layer, 1).contour_count());
  EXPECT_EQ(report.rings_after, feature.contour_count());
  EXPECT_TRUE(check(feature).is_valid());
  EXPECT_EQ(text_of(repaired.features, 0), text_of(layer, 0));

  const Repaired again = repair(repaired.features);
  EXPECT_TRUE(again.changed.empty());
  EXPECT_EQ(again.features, repaired.features);
}

INSTANTIATE_TEST_SUITE_P(All, RepairFaults, ::testing::ValuesIn(fault_cases()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Repair, LeavesValidFeaturesAsTheyAre) {
  const std::vector<std::string> valid = {
      "POLYGON ((0 0, 0 4, 4 4, 4 0, 0 0))",                                              // clockwise
      "POLYGON ((4 4, 0 4, 0 0, 4 0, 4 4))",                                              // another start
      "POLYGON ((0 0, 4 0, 4 0, 4 0, 4 4, 0 4, 0 0, 0 0))",                               // repeated points
      "POLYGON ((0 0, 2 0, 4 0, 4 4, 0 4, 0 0))",                                         // collinear
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 1))",                        // hole, either way
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (5 5, 6 6, 6 5, 5 5), (1 1, 1 2, 2 2, 1 1))",  // holes in any order
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 0, 2 1, 1 2, 0 0))",                        // touches at a vertex
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (5 0, 7 3, 3 3, 5 0))",                        // ... on an edge
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (5 0, 7 3, 3 3, 5 0), (5 3, 7 6, 3 6, 5 3))",  // ... on a hole's edge
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 4 4, 1 4, 1 1), (4 4, 7 4, 7 7, 4 4), (4 4, 4 7, 3 7, 4 4))",
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 3 1, 1 3, 1 1), (1 1, 1 0.5, 2 0.5, 1 1))",  // holes from one vertex
      "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((4 4, 8 4, 8 8, 4 8, 4 4)))",              // touch at a vertex
      "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((4 2, 8 0, 8 4, 4 2)))",                   // ... on an edge
      "MULTIPOLYGON (((4 2, 8 0, 8 4, 4 2)), ((0 0, 4 0, 4 4, 0 4, 0 0)))",                   // another order
      "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1)), ((3 3, 5 3, 5 5, 3 5, 3 3)))",
      "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1)), ((1 4, 4 1, 5 5, 1 4)))",
      // Two polygons that enclose a place between them, and touch twice.
      "MULTIPOLYGON (((0 0, 8 0, 8 2, 2 2, 0 6, 0 0)), ((8 2, 8 8, 0 8, 0 6, 6 6, 8 2)))",
      "MULTIPOLYGON EMPTY",
  };
  TextLayer layer(valid);
  layer.regions.points[0] = {-0.0, 0.0};
  const Repaired repaired = repair(layer);
  EXPECT_TRUE(repaired.changed.empty());
  EXPECT_EQ(texts_of(repaired.features), texts_of(layer));
  EXPECT_TRUE(std::signbit(repaired.features.regions.points[0].x));
  EXPECT_EQ(repaired.features.feature_ends, layer.ends);
  EXPECT_EQ(repaired.features.regions.contour_ends, layer.regions.contour_ends);
}

TEST(Repair, KeepsAClosingPoint) {
  const RegionSet square{{{0, 0}, {4, 0}, {4, 4}, {0, 0}}, {4}, {1}};
  const Repaired repaired = repair({square, {}});
  EXPECT_EQ(repaired.features.regions, square);
}

TEST(Repair, TakesEachContourAsAFeatureWithoutEnds) {
  const RegionSet contours{{{0, 0}, {4, 4}, {4, 0}, {0, 4}, {9, 9}, {10, 9}, {9, 10}}, {4, 7}, {}};
  const Repaired repaired = repair({contours, {}});
  ASSERT_EQ(repaired.changed.size(), 1U);
  EXPECT_EQ(texts_of(repaired.features),
            (std::vector<std::string>{"MULTIPOLYGON (((0 0, 2 2, 0 4, 0 0)), ((2 2, 4 0, 4 4, 2 2)))",
                                      "POLYGON ((9 9, 10 9, 9 10, 9 9))"}));
}

TEST(Repair, WorksOnPartsOfLargerArrays) {
  const TextLayer layer({"POLYGON ((50 50, 51 50, 50 51, 50 50))",
                         "MULTIPOLYGON (((0 0, 4 4, 4 0, 0 4, 0 0)), ((20 0, 21 0, 20 1, 20 0)))",
                         "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 1))"});
  const Repaired all = repair(layer);
  for (std::size_t f = 0; f < 3; ++f) {
    const auto end = static_cast<std::uint32_t>(verify::regions_of(layer, f).polygon_count());
    const Repaired alone = repair({verify::regions_of(layer, f), {&end, 1}});
    EXPECT_EQ(text_of(alone.features, 0), text_of(all.features, f));
  }
}

TEST(Repair, CountsRingsWithoutArea) {
  const TextLayer layer(
      {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 2, 3 3, 1 1), (5 5, 6 6, 5 5), (7 7, 8 7, 7 8, 7 7))"});
  const Repaired repaired = repair(layer);
  ASSERT_EQ(repaired.changed.size(), 1U);
  EXPECT_EQ(repaired.changed[0].rings_dropped, 2U);
  EXPECT_EQ(repaired.changed[0].rings_before, 4U);
  EXPECT_EQ(repaired.changed[0].rings_after, 2U);
}

TEST(Repair, NamesTheFeatureOfABadCoordinate) {
  TextLayer layer({"POLYGON ((0 0, 1 0, 0 1, 0 0))", "MULTIPOLYGON EMPTY",
                   "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((0 0, 1 0, 0 1, 0 0)))"});
  layer.regions.points[7].y = std::numeric_limits<double>::quiet_NaN();
  try {
    repair(layer);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::not_finite);
    EXPECT_EQ(error.place().feature, 2U);
    EXPECT_EQ(error.place().polygon, 2U);
    EXPECT_EQ(error.place().vertex, 1U);
  }
  EXPECT_THROW(repair_coverage(layer), Error);
}

TEST(Repair, RefusesEndsThatDoNotFit) {
  TextLayer layer({"POLYGON ((0 0, 1 0, 0 1, 0 0))"});
  layer.ends = {2};
  EXPECT_THROW(repair(layer), Error);
}

TEST(GroupRings, FindsTheHolesOfEachOuterRing) {
  const char* const heap =
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (20 0, 29 0, 29 9, 20 9, 20 0), (2 2, 7 2, 7 7, 2 7, 2 2), "
      "(22 1, 21 1, 21 2, 22 2, 22 1), (3 3, 4 3, 4 4, 3 4, 3 3))";
  const TextLayer layer({heap, "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0), (9 9, 8 9, 8 8, 9 9))", heap});
  const std::vector<std::uint32_t> without_roles{0, 1};
  const FeatureSet grouped = group_rings(layer, without_roles);
  EXPECT_EQ(text_of(grouped, 0),
            "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 7 2, 7 7, 2 7, 2 2)), ((20 0, 29 0, 29 9, 20 9, 20 0), "
            "(22 1, 21 1, 21 2, 22 2, 22 1)), ((3 3, 4 3, 4 4, 3 4, 3 3)))");
  EXPECT_EQ(text_of(grouped, 1), text_of(layer, 1));  // a ring crosses itself
  EXPECT_EQ(text_of(grouped, 2), text_of(layer, 2));  // its rings have roles
  const Repaired repaired = repair(grouped);
  ASSERT_EQ(repaired.changed.size(), 2U);
  EXPECT_EQ(repaired.changed[0].feature, 1U);
}

TEST(GroupRings, RefusesFeaturesThatThereAreNot) {
  const TextLayer layer({"POLYGON ((0 0, 4 0, 0 4, 0 0))", "POLYGON ((0 0, 4 0, 0 4, 0 0))"});
  EXPECT_THROW(group_rings(layer, std::vector<std::uint32_t>{2}), Error);
  EXPECT_THROW(group_rings(layer, std::vector<std::uint32_t>{1, 0}), Error);
}

TEST(Repair, TellsAndStops) {
  std::vector<std::string> texts;
  for (int i = 0; i < 3000; ++i) texts.emplace_back("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))");
  const TextLayer layer(texts);
  RepairOptions options;
  double last = 0;
  options.progress = [&](Stage, double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  };
  EXPECT_EQ(repair(layer, options).changed.size(), texts.size());
  EXPECT_EQ(last, 1);
  options.progress = [](Stage, double) { return false; };
  EXPECT_THROW(repair(layer, options), Error);
}

}  // namespace
}  // namespace oblast::testing
