// check against verify/: both call the same regions valid, and both find what was made wrong.
#include <gtest/gtest.h>
#include <oblast/check.h>
#include <oblast/overlay.h>

#include <cmath>
#include <set>

#include "check/mutate.h"
#include "generators/hostile.h"
#include "generators/wkt.h"
#include "verify/text_regions.h"
#include "verify/verify.h"

namespace oblast::testing {
namespace {

using verify::regions_of;

constexpr ContourConvention conventions[] = {ContourConvention::ogc, ContourConvention::leonov_nikitin};

std::optional<FaultKind> kind_of(const RegionSet& regions, const CheckOptions& options = {}) {
  const CheckReport report = check(regions, options);
  EXPECT_EQ(report.is_valid(), !report.fault);
  if (!report.fault) return {};
  EXPECT_FALSE(report.fault->message.empty());
  return report.fault->kind;
}

std::optional<FaultKind> kind_of(const std::string& text, const CheckOptions& options = {}) {
  return kind_of(regions_of(text), options);
}

TEST(Check, validRegionsHaveNoFault) {
  EXPECT_EQ(kind_of(RegionSet{}), std::nullopt);
  EXPECT_EQ(kind_of("0 0, 4 0, 4 4, 0 4"), std::nullopt);
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9; 1 1, 1 2, 2 2, 2 1; 2 2, 2 3, 3 3, 3 2"), std::nullopt);
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9; 1 1, 1 8, 8 8, 8 1 | 2 2, 3 2, 3 3, 2 3 | 3 3, 4 3, 4 4"), std::nullopt);
}

TEST(Check, namesEveryKind) {
  EXPECT_EQ(kind_of(RegionSet{{{0, 0}, {1, 0}, {1, 1}}, {4}, {1}}), FaultKind::bad_offsets);
  EXPECT_EQ(kind_of(RegionSet{{{0, 0}, {1, 0}, {1, 1}}, {3}, {2}}), FaultKind::bad_offsets);
  EXPECT_EQ(kind_of(RegionSet{{{0, 0}, {1, 0}, {1, 1}}, {3, 3}, {2}}), FaultKind::bad_offsets);
  EXPECT_EQ(kind_of(RegionSet{{{0, 0}, {1, 0}, {1, NAN}}, {3}, {1}}), FaultKind::not_finite);
  EXPECT_EQ(kind_of(RegionSet{{{0, 0}, {1, 0}, {1, 1e100}}, {3}, {1}}), FaultKind::out_of_domain);
  EXPECT_EQ(kind_of("0 0, 4 0"), FaultKind::too_few_vertices);
  EXPECT_EQ(kind_of("0 0, 4 0, 4 0, 4 4"), FaultKind::repeated_vertex);
  EXPECT_EQ(kind_of("0 0, 4 0, 4 4, 0 0"), FaultKind::repeated_vertex);
  EXPECT_EQ(kind_of("0 0, 4 0, 0 4, 4 4"), FaultKind::edges_cross);
  EXPECT_EQ(kind_of("0 0, 4 0, 2 0, 2 4"), FaultKind::edges_overlap);
  EXPECT_EQ(kind_of("0 0, 4 0, 4 4 | 2 0, 3 -1, 4 -1"), FaultKind::vertex_on_edge);
  EXPECT_EQ(kind_of("0 0, 4 0, 4 4 | 0 0, 4 0, 4 4"), FaultKind::edges_overlap);
  EXPECT_EQ(kind_of("0 0, 2 1, 4 0, 4 4, 2 1, 0 4"), FaultKind::touches_itself);
  EXPECT_EQ(kind_of("0 0, 0 4, 4 4, 4 0"), FaultKind::wrong_side);
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9 | 1 1, 2 1, 2 2"), FaultKind::wrong_side);
  EXPECT_EQ(kind_of("1 1, 1 2, 2 2, 2 1; 0 0, 9 0, 9 9, 0 9"), FaultKind::outer_is_not_first);
  EXPECT_EQ(kind_of("0 0, 1 0, 1 1; 2 0, 3 0, 3 1"), FaultKind::hole_is_outer);
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9 | 20 0, 29 0, 29 9, 20 9; 1 1, 1 2, 2 2, 2 1"), FaultKind::other_polygon);
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9; 0 0, 0 9, 9 9, 5 4"), FaultKind::edges_overlap);
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9; 0 0, 4 8, 9 9, 8 4"), FaultKind::not_connected);
  EXPECT_EQ(kind_of(RegionSet{{{-0.0, 0}, {1, 0}, {1, 1}}, {3}, {1}}), FaultKind::negative_zero);
  EXPECT_EQ(kind_of("4 0, 4 4, 0 4, 0 0"), FaultKind::wrong_start);
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9; 4 4, 4 5, 5 5; 1 1, 1 2, 2 2"), FaultKind::holes_out_of_order);
  EXPECT_EQ(kind_of("4 4, 5 4, 5 5 | 0 0, 1 0, 1 1"), FaultKind::polygons_out_of_order);
}

TEST(Check, saysWhere) {
  const Fault crossing = check(regions_of("9 9, 11 9, 11 11 | 0 0, 4 0, 0 4, 4 4")).fault.value();
  EXPECT_EQ(crossing.place.polygon, 1u);
  EXPECT_EQ(crossing.place.contour, 1u);
  EXPECT_EQ(crossing.place.vertex, 1u);
  EXPECT_EQ(crossing.other.contour, 1u);
  EXPECT_EQ(crossing.other.vertex, 3u);
  EXPECT_EQ(crossing.point, (Point{2, 2}));
  EXPECT_EQ(crossing.message, "edge (4 0) -> (0 4) and edge (4 4) -> (0 0) cross near (2 2)");
  const Fault start = check(regions_of("0 0, 1 0, 1 1 | 4 0, 4 4, 2 2")).fault.value();
  EXPECT_EQ(start.place.contour, 1u);
  EXPECT_EQ(start.place.vertex, 0u);
  EXPECT_EQ(start.other.vertex, 2u);
  EXPECT_EQ(start.message, "the contour starts at (4 0); it should start at (2 2)");
}

TEST(Check, whatIsNotAskedForIsNoFault) {
  CheckOptions any;
  any.order = CheckedOrder::any;
  EXPECT_EQ(kind_of("4 0, 4 4, 0 4, 0 0 | -4 0, -3 0, -3 -0.0001, -2 5", any), std::nullopt);
  CheckOptions hugging;
  hugging.contours = ContourConvention::leonov_nikitin;
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9; 1 1, 1 2, 2 2, 2 3, 3 3, 3 2, 2 2, 2 1", hugging), std::nullopt);
  EXPECT_EQ(kind_of("0 0, 9 0, 9 9, 0 9; 1 1, 1 2, 2 2, 2 1; 2 2, 2 3, 3 3, 3 2", hugging), FaultKind::touches_itself);
}

TEST(Check, viewsOfAPartAreCheckedByThemselves) {
  const RegionSet set = regions_of("0 0, 1 0, 1 1 | 4 0, 4 4, 2 2 | 5 0, 6 0, 6 1");
  EXPECT_TRUE(check(set.polygon(2)).is_valid());
  EXPECT_EQ(check(set.polygon(1)).fault.value().place.contour, 0u);
}

/// Whether verify/ finds no fault either.
void expect_agreement(const RegionSet& regions, ContourConvention convention, std::set<FaultKind>& seen,
                      const std::string& what) {
  CheckOptions options;
  options.contours = convention;
  const CheckReport report = check(regions, options);
  if (report.fault) seen.insert(report.fault->kind);
  const auto fault = verify::check_result(regions, convention);
  ASSERT_EQ(report.is_valid(), !fault) << what << "\ncheck:  " << (report.fault ? report.fault->message : "valid")
                                       << "\nverify: " << (fault ? fault->what : "valid");
  options.order = CheckedOrder::any;
  ASSERT_EQ(check(regions, options).is_valid(), !verify::check_closed(regions, convention)) << what;
}

class CheckHostile : public ::testing::TestWithParam<generators::HostileGenerator> {};

TEST_P(CheckHostile, resultsAreValidAndSpoiledOnesAreJudgedAsByVerify) {
  std::set<FaultKind> seen;
  generators::Random random(7);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto [a, b] = GetParam().make(seed, seed % 4 == 0 ? GetParam().larger / 2 : GetParam().usual);
    for (const ContourConvention convention : conventions) {
      Options options;
      options.contours = convention;
      const RegionSet result = overlay(a, b, Operation::symmetric_difference, options);
      CheckOptions check_options;
      check_options.contours = convention;
      const CheckReport report = check(result, check_options);
      EXPECT_TRUE(report.is_valid()) << "seed " << seed << ": " << (report.fault ? report.fault->message : "");
      if (result.points.empty()) continue;
      for (const Mutation& mutation : mutations()) {
        const std::string what = "seed " + std::to_string(seed) + ", " + mutation.name;
        const RegionSet once = mutation.make(result, random);
        ASSERT_NO_FATAL_FAILURE(expect_agreement(once, convention, seen, what)) << what;
      }
    }
  }
  EXPECT_GE(seen.size(), 8u) << "mutations that break little";
}

INSTANTIATE_TEST_SUITE_P(Generators, CheckHostile, ::testing::ValuesIn(generators::hostile_generators()),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           for (char& letter : name)
                             if (letter == ' ') letter = '_';
                           return name;
                         });

TEST(Check, findsTheSameFaultOnAnyNumberOfThreads) {
  const auto [a, b] = generators::coverages(2, 20000);
  const RegionSet result = overlay(a, b, Operation::symmetric_difference);
  EXPECT_TRUE(check(result).is_valid());
  generators::Random random(3);
  for (const Mutation& mutation : mutations()) {
    const RegionSet spoiled = mutation.make(mutation.make(result, random), random);
    CheckOptions one, many;
    one.threads = 1;
    many.threads = 8;
    const auto expected = check(spoiled, one).fault, found = check(spoiled, many).fault;
    ASSERT_EQ(expected.has_value(), found.has_value()) << mutation.name;
    if (expected) {
      EXPECT_EQ(expected->message, found->message) << mutation.name;
    }
    EXPECT_EQ(!expected, !verify::check_result(spoiled)) << mutation.name;
  }
}

}  // namespace
}  // namespace oblast::testing
