// The C interface: the same results as the C++ one, errors with their place, cancelling, options.
#include <gtest/gtest.h>
#include <oblast/c.h>
#include <oblast/oblast.h>

#include <vector>

#include "generators/hostile.h"

namespace oblast::internal {
namespace {

oblast_view view_of(const RegionSet& set) {
  return {reinterpret_cast<const double*>(set.points.data()),
          set.points.size(),
          set.contour_ends.data(),
          set.contour_ends.size(),
          set.polygon_ends.data(),
          set.polygon_ends.size()};
}

RegionSet set_of(const oblast_regions* regions) {
  const oblast_view v = oblast_regions_view(regions);
  RegionSet set;
  for (std::size_t i = 0; i < v.point_count; ++i) set.points.push_back({v.points[2 * i], v.points[2 * i + 1]});
  set.contour_ends.assign(v.contour_ends, v.contour_ends + v.contour_count);
  set.polygon_ends.assign(v.polygon_ends, v.polygon_ends + v.polygon_count);
  return set;
}

const RegionSet square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {4}, {1}};

TEST(C, givesTheBytesOfTheLibrary) {
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const generators::Operands o = generator.make(seed, 24);
      for (int op = 0; op < 4; ++op) {
        const oblast_view a = view_of(o.a), b = view_of(o.b);
        oblast_regions* result = nullptr;
        oblast_error error;
        ASSERT_EQ(oblast_overlay(&a, &b, op, nullptr, &result, &error), OBLAST_OK) << error.message;
        EXPECT_EQ(set_of(result), overlay(o.a, o.b, static_cast<Operation>(op)));
        oblast_regions_free(result);
      }
    }
  }
}

TEST(C, optionsCount) {
  oblast_options* options = oblast_options_new();
  oblast_options_set_fill(options, 0, OBLAST_FILL_AT_LEAST, 2);
  oblast_options_set_minimal(options, 1);
  oblast_options_set_threads(options, 1);
  oblast_options_set_workspace(options, 1);
  const RegionSet twice{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {6, 0}, {6, 4}, {2, 4}}, {4, 8}, {1, 2}};
  const oblast_view a = view_of(twice);
  oblast_regions* result = nullptr;
  ASSERT_EQ(oblast_unite(&a, options, &result, nullptr), OBLAST_OK);
  EXPECT_EQ(set_of(result), (RegionSet{{{2, 0}, {4, 0}, {4, 4}, {2, 4}}, {4}, {1}}));
  const oblast_view united = oblast_regions_view(result);
  EXPECT_EQ(oblast_signed_area(&united, nullptr), 8);
  oblast_regions_free(result);
  oblast_options_free(options);
}

TEST(C, errorsSayWhere) {
  oblast_error error;
  oblast_regions* result = nullptr;
  const RegionSet bad{{{0, 0}, {4, 0}, {4, std::numeric_limits<double>::quiet_NaN()}}, {3}, {1}};
  const oblast_view a = view_of(square), b = view_of(bad);
  EXPECT_EQ(oblast_overlay(&a, &b, OBLAST_UNION, nullptr, &result, &error), OBLAST_NOT_FINITE);
  EXPECT_EQ(result, nullptr);
  EXPECT_EQ(error.operand, 1u);
  EXPECT_EQ(error.contour, 0u);
  EXPECT_EQ(error.vertex, 2u);
  EXPECT_NE(error.message[0], 0);

  const std::uint32_t past_the_end = 9;
  oblast_view offsets = a;
  offsets.contour_ends = &past_the_end;
  EXPECT_EQ(oblast_unite(&offsets, nullptr, &result, &error), OBLAST_BAD_OFFSETS);
  EXPECT_EQ(oblast_overlay(&a, &a, 17, nullptr, &result, &error), OBLAST_BAD_OPTION);
  EXPECT_EQ(oblast_overlay(&a, nullptr, OBLAST_UNION, nullptr, &result, &error), OBLAST_NULL_POINTER);
  EXPECT_EQ(oblast_unite(&a, nullptr, nullptr, &error), OBLAST_NULL_POINTER);
  oblast_view without_points = a;
  without_points.points = nullptr;
  EXPECT_EQ(oblast_unite(&without_points, nullptr, &result, nullptr), OBLAST_NULL_POINTER);
}

TEST(C, progressCancels) {
  const generators::Operands o = generators::hostile_generators()[0].make(1, 3000);
  const oblast_view a = view_of(o.a), b = view_of(o.b);
  oblast_options* options = oblast_options_new();
  int asked = 0;
  oblast_options_set_progress(
      options, [](double, void* data) { return static_cast<int>(++*static_cast<int*>(data) < 2); }, &asked);
  oblast_regions* result = nullptr;
  oblast_error error;
  EXPECT_EQ(oblast_overlay(&a, &b, OBLAST_UNION, options, &result, &error), OBLAST_CANCELLED);
  EXPECT_EQ(asked, 2);
  oblast_options_set_progress(options, nullptr, nullptr);
  oblast_options_set_memory(options, 1000);
  EXPECT_EQ(oblast_overlay(&a, &b, OBLAST_UNION, options, &result, &error), OBLAST_MEMORY_LIMIT);
  oblast_options_free(options);
}

TEST(C, knowsItsVersion) { EXPECT_EQ(oblast_version(), OBLAST_VERSION_NUMBER); }

}  // namespace
}  // namespace oblast::internal
