// The public triangulation: its contents, and an exact check on hostile input.
#include <gtest/gtest.h>
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include "generators/hostile.h"
#include "generators/trial.h"
#include "support/check_mesh.h"
#include "support/exact_signs.h"
#include "verify/text_regions.h"

namespace oblast::testing {
namespace {

using verify::regions_of;

TriangulateOptions options_of(TriangleExtent extent, TriangleInput input, const Options& unite = {}) {
  TriangulateOptions options;
  static_cast<Options&>(options) = unite;
  options.extent = extent;
  options.input = input;
  return options;
}

const TriangulateOptions whole_hull = options_of(TriangleExtent::convex_hull, TriangleInput::any);

double doubled_area(const Triangulation& t, std::size_t i) {
  const Point &a = t.points[t.triangles[i][0]], &b = t.points[t.triangles[i][1]], &c = t.points[t.triangles[i][2]];
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(Triangulate, nothing) {
  const Triangulation t = triangulate(RegionView{});
  EXPECT_TRUE(t.triangles.empty());
  EXPECT_TRUE(t.points.empty());
}

TEST(Triangulate, aSquareWithAHoleAndAnIsland) {
  const RegionSet regions = regions_of("0 0, 9 0, 9 9, 0 9; 2 2, 2 7, 7 7, 7 2 | 3 3, 6 3, 6 6, 3 6");
  const Triangulation inside = triangulate(regions);
  EXPECT_EQ(inside.regions, unite(regions));
  EXPECT_EQ(inside.points.size(), 12u);
  double area[2] = {0, 0};
  for (std::size_t i = 0; i < inside.triangles.size(); ++i) {
    ASSERT_LT(inside.polygon[i], 2u);
    area[inside.polygon[i]] += doubled_area(inside, i);
    for (int s = 0; s < 3; ++s) {
      const std::uint32_t beyond = inside.neighbours[i][s];
      EXPECT_EQ(beyond == Triangulation::none, inside.is_side[i][s]);  // the border is all sides
      if (beyond == Triangulation::none) continue;
      EXPECT_EQ(inside.polygon[beyond], inside.polygon[i]);
    }
  }
  EXPECT_EQ(area[0], 2 * (81 - 25));
  EXPECT_EQ(area[1], 2 * 9);

  const Triangulation all = triangulate(regions, whole_hull);
  double hull = 0;
  for (std::size_t i = 0; i < all.triangles.size(); ++i) hull += doubled_area(all, i);
  EXPECT_EQ(hull, 2 * 81);
  const auto fault = check_triangulation(all);
  EXPECT_FALSE(fault) << *fault;
}

TEST(Triangulate, takesAnyInput) {
  const Triangulation bow_tie = triangulate(regions_of("0 0, 2 2, 2 0, 0 2"), whole_hull);
  EXPECT_EQ(bow_tie.points.size(), 5u);
  EXPECT_EQ(bow_tie.regions.polygon_ends.size(), 2u);
  const auto fault = check_triangulation(bow_tie);
  EXPECT_FALSE(fault) << *fault;
}

TEST(Triangulate, takesAResultAsItIs) {
  // Neighbours that share a border are no result of a union, but closed: each keeps its own triangles.
  const RegionSet coverage = regions_of("0 0, 2 0, 2 2, 0 2 | 2 0, 4 0, 4 2, 2 2");
  const Triangulation t = triangulate(coverage, options_of(TriangleExtent::interior, TriangleInput::result));
  EXPECT_EQ(t.regions, coverage);
  EXPECT_EQ(t.points.size(), 6u);
  ASSERT_EQ(t.triangles.size(), 4u);
  double area[2] = {0, 0};
  for (std::size_t i = 0; i < 4; ++i) area[t.polygon[i]] += doubled_area(t, i);
  EXPECT_EQ(area[0], 8);
  EXPECT_EQ(area[1], 8);
}

TEST(Triangulate, refusesCrossingSidesOfAResult) {
  const TriangulateOptions as_result = options_of(TriangleExtent::interior, TriangleInput::result);
  try {
    triangulate(regions_of("0 0, 4 0, 4 4, 0 4 | 2 2, 6 2, 6 6, 2 6"), as_result);
    FAIL() << "nothing was thrown";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::precondition);
  }
}

class TriangulateHostile : public ::testing::TestWithParam<generators::HostileGenerator> {};

TEST_P(TriangulateHostile, isExactlyRight) {
  std::size_t triangles = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const generators::Operands operands = GetParam().make(seed, 60);
    const generators::Request request = generators::draw_request(seed);
    Options options;
    options.fill_a = request.fill_a;
    options.contours = request.contours;
    const Triangulation t =
        triangulate(operands.a, options_of(TriangleExtent::convex_hull, TriangleInput::any, options));
    const auto fault = check_triangulation(t);
    ASSERT_FALSE(fault) << "seed " << seed << ": " << *fault;
    triangles += t.triangles.size();
  }
  EXPECT_GT(triangles, 200u);
}

std::string name_of(const ::testing::TestParamInfo<generators::HostileGenerator>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Generators, TriangulateHostile,
                         ::testing::ValuesIn(generators::hostile_generators().begin(),
                                             generators::hostile_generators().end()),
                         name_of);

}  // namespace
}  // namespace oblast::testing
