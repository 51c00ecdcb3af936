// Edges that cancel leave nothing behind, unless the straight edge would meet something.
#include "result/remove_traces.h"

#include <gtest/gtest.h>
#include <oblast/overlay.h>

#include <algorithm>

#include "generators/random.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using verify::regions_of;

/// Rings with the vertices numbered in `traces` flagged, and those that lie at one place as touching.
Rings rings_of(const std::string& text, const std::vector<std::size_t>& traces, std::uint8_t flag = trace_vertex) {
  const RegionSet set = regions_of(text);
  Rings rings;
  rings.points.assign(set.points.begin(), set.points.end());
  rings.ends.assign(set.contour_ends.begin(), set.contour_ends.end());
  rings.flags.assign(rings.points.size(), 0);
  for (const std::size_t v : traces) {
    rings.flags[v] = flag;
    if (flag == trace_vertex) rings.trace_edges.push_back({static_cast<std::uint32_t>(v), 0});
  }
  std::ranges::sort(rings.trace_edges);
  for (std::size_t v = 0; v < rings.points.size(); ++v)
    if (std::ranges::count(rings.points, rings.points[v]) > 1) rings.flags[v] |= touch_vertex;
  return rings;
}

void expect_points(const Rings& rings, const std::string& text) {
  const RegionSet set = regions_of(text);
  EXPECT_TRUE(std::ranges::equal(rings.points, set.points));
  EXPECT_TRUE(std::ranges::equal(rings.ends, set.contour_ends));
}

TEST(RemoveTraces, takesThemOut) {
  expect_points(remove_traces(rings_of("0 0, 2 0.5, 6 3.5, 8 4, 0 4", {1, 2}), CollinearVertices::keep),
                "0 0, 8 4, 0 4");
  // Also if a ring begins with them.
  expect_points(remove_traces(rings_of("6 3.5, 8 4, 0 4, 0 0, 2 0.5", {0, 4}), CollinearVertices::keep),
                "8 4, 0 4, 0 0");
}

TEST(RemoveTraces, withoutAnyChangesNothing) {
  const std::string text = "0 0, 2 0, 4 0, 4 4, 0 4 | 9 9, 10 9, 10 10";
  expect_points(remove_traces(rings_of(text, {}), CollinearVertices::keep), text);
}

TEST(RemoveTraces, keepsThemWhereTheStraightEdgeWouldCross) {
  // The tip of the other ring reaches across the straight edge, towards the trace vertex.
  const std::string text = "0 0, 4 1, 8 4, 0 4 | 4 1.5, 4 3.5, 3 3.5";
  expect_points(remove_traces(rings_of(text, {1}), CollinearVertices::keep), text);
  // It ends on the straight edge.
  const std::string touching = "0 0, 4 1, 8 4, 0 4 | 4 2, 4 3.5, 3 3.5";
  expect_points(remove_traces(rings_of(touching, {1}), CollinearVertices::keep), touching);
  // It stays above.
  expect_points(remove_traces(rings_of("0 0, 4 1, 8 4, 0 4 | 4 2.5, 4 3.5, 3 3.5", {1}), CollinearVertices::keep),
                "0 0, 8 4, 0 4 | 4 2.5, 4 3.5, 3 3.5");
}

TEST(RemoveTraces, takesThemOutWhereTheyLeaveTheBoxOfTheStraightEdge) {
  expect_points(remove_traces(rings_of("0 0, 4 -1, 8 4, 0 4", {1}), CollinearVertices::keep), "0 0, 8 4, 0 4");
  // But not over a vertex outside that box.
  const std::string over = "0 0, 4 -1, 8 4, 0 4 | 4 -0.75, 4.125 -0.5, 4 -0.5";
  expect_points(remove_traces(rings_of(over, {1}), CollinearVertices::keep), over);
}

TEST(RemoveTraces, keepsThemWhereTheStraightEdgeWouldPassOverAVertex) {
  // The small ring lies whole between the edge's pieces and the straight edge: neither would cross it.
  const std::string text = "0 0, 2 2, 4 4, 0 4 | 2 1.5, 2.1 1.5, 2.1 1.6";
  const std::string bent = "0 0, 3 1, 4 4, 0 4 | 2.4 2, 2.5 2, 2.5 2.1";
  expect_points(remove_traces(rings_of(bent, {1}), CollinearVertices::keep), bent);
  expect_points(remove_traces(rings_of(text, {1}), CollinearVertices::keep), "0 0, 4 4, 0 4 | 2 1.5, 2.1 1.5, 2.1 1.6");
}

TEST(RemoveTraces, takesThemOutAlthoughAnotherWasInTheWayWhenStraight) {
  // Straight, the two rings' edges meet beside (2.5 2.5).
  const Rings rings = rings_of("0 0, 3 2, 2.5 2.5, 2 3, 1 1.5 | 0 5, 1.5000000000000002 3.5, 2.5 2.5, 4 4", {4, 6});
  expect_points(remove_traces(rings, CollinearVertices::keep),
                "0 0, 3 2, 2.5 2.5, 2 3 | 0 5, 1.5000000000000002 3.5, 2.5 2.5, 4 4");
}

TEST(RemoveTraces, takesTheSmallerOutWhereEitherCanGo) {
  // Two rings meet at both ends of one straight edge, and bend away from it to either side.
  const std::string upper = "0 0, 4 3, 8 4, 0 8", lower = "0 0, 9 -8, 8 4, 4 1", straight = "0 0, 9 -8, 8 4";
  expect_points(remove_traces(rings_of(upper + " | " + lower, {1, 7}), CollinearVertices::keep),
                upper + " | " + straight);
  expect_points(remove_traces(rings_of(lower + " | " + upper, {3, 5}), CollinearVertices::keep),
                straight + " | " + upper);
}

TEST(RemoveTraces, takesOneOfTwoOutOfAnEdge) {
  const Rings rings = rings_of("0 0, 4 1, 6 2.25, 8 4, 0 4 | 4 1.5, 4 3.5, 3 3.5", {1, 2});
  expect_points(remove_traces(rings, CollinearVertices::keep), "0 0, 4 1, 8 4, 0 4 | 4 1.5, 4 3.5, 3 3.5");
}

// The straight edge meets nothing, so a search for edges that meet does not bring the ring to it.
TEST(RemoveTraces, keepsThemOverASmallRingAmongManyLongEdges) {
  // As above, but a bundle of slivers beside it, parallel to the straight edge, makes the search clip edges and
  // cut along them: such a cut parts the small ring from the straight edge.
  Rings rings = rings_of("0 0, 4 1, 8 4, 0 4 | 4 1.75, 4.125 1.75, 4.125 1.875", {1});
  for (int i = -400; i < 400; ++i) {
    const double c = i / 256.0;
    rings.points.insert(rings.points.end(), {{9, 4.5 + c}, {73, 36.5 + c}, {73, 36.501 + c}});
    rings.ends.push_back(static_cast<std::uint32_t>(rings.points.size()));
  }
  rings.flags.resize(rings.points.size(), 0);
  const Rings result = remove_traces(rings, CollinearVertices::keep);
  EXPECT_EQ(result.points, rings.points);
}

TEST(RemoveTraces, givesBackOnlyWhatIsInTheWay) {
  // Two edges with a trace each; only one of them has something between.
  const Rings rings = rings_of("0 0, 4 1, 8 4, 5 5, 0 8 | 4 1.5, 4 3.5, 3 3.5", {1, 3});
  expect_points(remove_traces(rings, CollinearVertices::keep), "0 0, 4 1, 8 4, 0 8 | 4 1.5, 4 3.5, 3 3.5");
}

TEST(RemoveTraces, takesManyOutOfOneEdgeAlthoughOneMustStay) {
  // A long slanting edge with very many traces, a tip that reaches across it at one of them, and many rings in its box.
  // Were each trace tried against all the others, or each ring against all traces, this would take an hour.
  constexpr std::uint32_t n = 1 << 19, middle = n / 2 + 1;
  const auto trace = [](std::uint32_t i) { return Point{i / 1.0, i / 3.0 - (i % 2 == 1 ? 0.25 : 0)}; };
  Rings rings, expected;
  for (std::uint32_t i = 0; i <= n; ++i) {
    rings.points.push_back(trace(i));
    rings.flags.push_back(i == 0 || i == n ? 0 : trace_vertex);
    if (rings.flags.back()) rings.trace_edges.push_back({i, 0});
  }
  expected.points.insert(expected.points.end(), {trace(0), trace(middle), trace(n)});
  const auto add = [&](const std::vector<Point>& points) {
    for (Rings* to : {&rings, &expected}) {
      to->points.insert(to->points.end(), points.begin(), points.end());
      to->ends.push_back(static_cast<std::uint32_t>(to->points.size()));
    }
  };
  add({{0, n}});
  const double x = middle, y = middle / 3.0;
  add({{x, y - 0.125}, {x, y + 3}, {x - 1, y + 3}});
  for (int i = 10; i < static_cast<int>(n); i += 10)
    add({{i + 0.5, i / 3.0 - 2}, {i + 1.0, i / 3.0 - 3}, {i + 1.0, i / 3.0 - 2}});
  rings.flags.resize(rings.points.size(), 0);
  const Rings result = remove_traces(rings, CollinearVertices::keep);
  EXPECT_EQ(result.points, expected.points);
  EXPECT_EQ(result.ends, expected.ends);
}

TEST(RemoveTraces, dropsCollinearVerticesWhenTold) {
  const Rings rings = rings_of("0 0, 1 0, 2 0, 4 0, 4 4, 0 4", {});
  expect_points(remove_traces(rings, CollinearVertices::drop), "0 0, 4 0, 4 4, 0 4");
  // Not at vertices where contours touch, nor at the slightest turn.
  expect_points(remove_traces(rings_of("0 0, 1 0, 2 0, 4 0, 4 4, 0 4", {2}, touch_vertex), CollinearVertices::drop),
                "0 0, 2 0, 4 0, 4 4, 0 4");
  expect_points(remove_traces(rings_of("0 0, 2 1e-300, 4 0, 4 4, 0 4", {}), CollinearVertices::drop),
                "0 0, 2 1e-300, 4 0, 4 4, 0 4");
}

TEST(RemoveTraces, nothingIsLeftOfBordersInsideTheOtherOperand) {
  // B is a strip cut in two along a border that cancels only after noding, for one side has a vertex more. A lies
  // inside the strip and across the border: the intersection is A, to the bit.
  generators::Random random(1);
  for (int round = 0; round < 300; ++round) {
    const auto number = [&](double low, double high) { return random.in(low, high); };
    const Point top{number(4, 6), 20}, bottom{number(4, 6), -20}, left{-30, 0}, right{40, 0}, tip{top.x, 25};
    RegionSet a, b;
    a.points = {{number(0, 1), number(0, 1)},
                {number(9, 10), number(0, 1)},
                {number(9, 10), number(9, 10)},
                {number(0, 1), number(9, 10)}};
    a.contour_ends = {4};
    b.points = {left,   {left.x, -20},  bottom,        top, {left.x, 20},  // west of the border
                bottom, {right.x, -20}, {right.x, 25}, tip, top};          // east of it
    b.contour_ends = {5, 10};
    const RegionSet result = overlay(a, b, Operation::intersection);
    ASSERT_EQ(result, unite(a)) << round;
  }
}

}  // namespace
}  // namespace oblast::internal
