// The exact arrangement: it finds edges that are not settled, and knows the areas of drawings by hand.
#include "verify/arrangement.h"

#include <gtest/gtest.h>

#include "generators/random.h"
#include "verify/rational.h"
#include "verify/text_regions.h"

namespace oblast::verify {
namespace {

enum class Of { a, b };

void add(std::vector<NodedEdge>& edges, const std::string& text, Of operand) {
  const RegionSet regions = regions_of(text);
  const RegionView view = regions;
  for (std::size_t c = 0; c < view.contour_count(); ++c) {
    const auto contour = view.contour(c);
    for (std::size_t v = 0; v < contour.size(); ++v)
      edges.push_back({contour[v], contour[(v + 1) % contour.size()], operand == Of::a, operand == Of::b});
  }
}

NodedArrangement drawn(const std::string& a, const std::string& b, const FillRule& rule = FillRule::nonzero()) {
  std::vector<NodedEdge> edges;
  add(edges, a, Of::a);
  add(edges, b, Of::b);
  return {std::move(edges), rule, rule};
}

// Two squares of side 4 that overlap in one of side 2, cut where they cross.
const std::string low = "0 0, 4 0, 4 2, 4 4, 2 4, 0 4", high = "2 2, 4 2, 6 2, 6 6, 2 6, 2 4";

TEST(NodedArrangement, findsEdgesThatAreNotSettled) {
  EXPECT_FALSE(drawn(low, high).check_settled());
  EXPECT_TRUE(drawn("0 0, 4 0, 4 4, 0 4", "2 2, 6 2, 6 6, 2 6").check_settled()) << "crossing";
  EXPECT_TRUE(drawn("0 0, 4 0, 4 4, 0 4", "4 1, 6 1, 6 2").check_settled()) << "touching inside an edge";
  EXPECT_TRUE(drawn("0 0, 4 0, 4 4, 0 4", "4 0, 4 4, 6 2").check_settled()) << "one edge twice";
}

TEST(NodedArrangement, knowsAreas) {
  // The unit of the scale is the last place of the smallest coordinate: ratios are what one can name here.
  const auto areas = drawn(low, high).twice_areas();
  const WideInteger square = areas.a / 16;
  EXPECT_NE(square, 0);
  EXPECT_EQ(areas.a, 16 * square);
  EXPECT_EQ(areas.b, 16 * square);
  const auto of = [&](Operation operation) { return areas.by_operation[static_cast<int>(operation)]; };
  EXPECT_EQ(of(Operation::intersection), 4 * square);
  EXPECT_EQ(of(Operation::unite), 28 * square);
  EXPECT_EQ(of(Operation::difference), 12 * square);
  EXPECT_EQ(of(Operation::symmetric_difference), 24 * square);
}

TEST(NodedArrangement, followsTheFillRule) {
  const std::string nested = "0 0, 4 0, 4 4, 0 4; 1 1, 3 1, 3 3, 1 3";
  const auto area = [&](const FillRule& rule) {
    const NodedArrangement arrangement = drawn(nested, "", rule);
    const RegionSet outer = regions_of("0 0, 4 0, 4 4, 0 4");
    return std::pair(arrangement.twice_areas().a, arrangement.twice_area_of(outer.points) / 16);
  };
  const auto expect = [&](const FillRule& rule, int squares) {
    const auto [found, square] = area(rule);
    EXPECT_EQ(found, squares * square);
  };
  expect(FillRule::nonzero(), 16);
  expect(FillRule::even_odd(), 12);
  expect(FillRule::at_least(2), 4);
  expect(FillRule::negative(), 0);
}

TEST(Scale, keepsSignsOfDeterminantsAtAnyMagnitude) {
  generators::Random random(3);
  const auto coordinate = [&] {
    return random.one_in(9) ? 0.0 : std::ldexp(random.in(-1, 1), random.between(-290, 299));
  };
  for (int i = 0; i < 2000; ++i) {
    Point p[3];
    for (Point& q : p) q = {coordinate(), coordinate()};
    if (random.one_in(3)) p[2] = {(p[0].x + p[1].x) / 2, (p[0].y + p[1].y) / 2};
    const Scale scale(p);
    const RationalPoint a(p[0]), b(p[1]), c(p[2]);
    const Rational exact = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    ASSERT_EQ(determinant(scale(p[0]), scale(p[1]), scale(p[2])).sign(), exact.sign());
  }
}

}  // namespace
}  // namespace oblast::verify
