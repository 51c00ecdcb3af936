// Meetings: which cuts each way of meeting asks for, and their order; a function of the set of edges alone.
#include "noding/meetings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "generators/random.h"
#include "support/strands_of.h"
#include "verify/rational.h"

namespace oblast::internal::noding {
namespace {

using generators::Random;
using testing::closed;
using testing::edges_of;
using testing::Path;
using testing::strands_of;

LargeArray<EdgeCut> meetings(Strands& strands, Settling settling = {}) {
  return find_meetings(strands, Grouping::by_strand, settling);
}

bool is_node(const Strands& strands, std::uint32_t v) { return (strands.flags[v] & node_flag) != 0; }

/// Vertices flagged as nodes.
std::vector<std::uint32_t> nodes(const Strands& strands) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t v = 0; v < strands.flags.size(); ++v)
    if (is_node(strands, v)) found.push_back(v);
  return found;
}

struct Expected {
  std::vector<std::pair<std::uint32_t, Point>> cuts;
  std::vector<std::uint32_t> nodes;
};

void expect_meetings(const std::vector<Path>& paths, const Expected& expected) {
  Strands strands = strands_of(paths);
  std::vector<std::pair<std::uint32_t, Point>> cuts;
  for (const EdgeCut& cut : meetings(strands)) cuts.emplace_back(cut.edge, cut.at);
  EXPECT_EQ(cuts, expected.cuts);
  EXPECT_EQ(nodes(strands), expected.nodes);
}

TEST(Meetings, ofEachKind) {
  // Edge 0 is (0, 0) to (4, 0), with vertices 0 and 1; the other edge is 2.
  const Path edge{{0, 0}, {4, 0}};
  expect_meetings({edge, {{2, -1}, {2, 1}}}, {{{0, {2, 0}}, {2, {2, 0}}}, {}});     // crossing
  expect_meetings({edge, {{2, 0}, {2, 1}}}, {{{0, {2, 0}}}, {2}});                  // T-junction
  expect_meetings({edge, {{4, 0}, {5, 5}}}, {{}, {1, 2}});                          // end to end
  expect_meetings({edge, {{4, -1}, {4, 1}}}, {{{2, {4, 0}}}, {1}});                 // crossing at an end
  expect_meetings({edge, {{1, 0}, {6, 0}}}, {{{0, {1, 0}}, {2, {4, 0}}}, {1, 2}});  // overlap
  expect_meetings({edge, {{3, 0}, {1, 0}}}, {{{0, {1, 0}}, {0, {3, 0}}}, {2, 3}});  // contained
  expect_meetings({edge, {{0, 0}, {3, 0}}}, {{{0, {3, 0}}}, {0, 2, 3}});            // contained, common end
  expect_meetings({edge, {{4, 0}, {0, 0}}}, {{}, {0, 1, 2, 3}});                    // the same edge, reversed
  expect_meetings({edge, {{5, 0}, {6, 0}}}, {{}, {}});                              // collinear, apart
  expect_meetings({edge, {{2, 1}, {3, 5}}}, {{}, {}});                              // apart
}

TEST(Meetings, edgesThatFollowOneAnotherDoNotMeet) {
  expect_meetings({closed({{0, 0}, {4, 0}, {4, 4}, {2, 2}})}, {{}, {}});
  expect_meetings({{{0, 0}, {2, 1}, {0, 2}}}, {{}, {}});
}

TEST(Meetings, foldsAreNodes) {
  Strands strands = strands_of({{{0, 0}, {4, 0}, {1, 0}}});
  const auto cuts = meetings(strands);
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_EQ(cuts[0].edge, 0u);
  EXPECT_EQ(cuts[0].at, (Point{1, 0}));
  EXPECT_TRUE(is_node(strands, 1));  // where it turns back
  EXPECT_TRUE(is_node(strands, 2));
}

TEST(Meetings, edgesOfOneGroupAreNotTested) {
  Strands strands = strands_of({{{0, 0}, {4, 0}}, {{2, -1}, {2, 1}}}, {1, 0}, 3);
  EXPECT_TRUE(meetings(strands).empty());
  strands.group[1] = 4;
  EXPECT_EQ(meetings(strands).size(), 2u);
}

std::vector<Path> soup(Random& random, int edges) {
  const int kind = random.below(3);
  std::vector<Path> paths;
  while (static_cast<int>(paths.size()) < edges) {
    const auto point = [&] {
      if (kind == 0) return Point{1.0 * random.below(7), 1.0 * random.below(7)};
      if (kind == 1) return Point{random.unit(), random.unit()};
      return Point{1 + random.below(3) * 0x1p-52 + random.below(2), 1 + random.below(3) * 0x1p-52 + random.below(2)};
    };
    const Point p = point(), q = point();
    if (p != q) paths.push_back({p, q});
  }
  return paths;
}

/// An edge by its smaller and larger end, and a cut of it.
using CutOfEdge = std::array<double, 6>;

CutOfEdge cut_of(Point a, Point b, const Point& at) {
  if (lexicographically_less(b, a)) std::swap(a, b);
  return {a.x, a.y, b.x, b.y, at.x, at.y};
}

std::vector<CutOfEdge> sorted_cuts(const Strands& strands, const LargeArray<EdgeCut>& cuts) {
  std::vector<CutOfEdge> all;
  for (const EdgeCut& cut : cuts) all.push_back(cut_of(strands.points[cut.edge], strands.points[cut.edge + 1], cut.at));
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Meetings, areSortedAlongTheirEdgesEachOnceInTheirBoxes) {
  Random random(1);
  for (int round = 0; round < 60; ++round) {
    Strands strands = strands_of(soup(random, 60));
    const Settling settling = Settling::of_round(round % 3 == 0 ? 1 : round % 3 == 1 ? 5 : 40);
    const auto cuts = meetings(strands, settling);
    EXPECT_FALSE(cuts.empty());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const Point &a = strands.points[cuts[i].edge], &b = strands.points[cuts[i].edge + 1];
      ASSERT_TRUE(cuts[i].at != a && cuts[i].at != b);
      ASSERT_TRUE(Box::of(a, b).meets(Box::of(cuts[i].at, cuts[i].at)));
      if (i == 0 || cuts[i - 1].edge != cuts[i].edge) {
        ASSERT_TRUE(i == 0 || cuts[i - 1].edge < cuts[i].edge);
        continue;
      }
      // From the cut before, the edge goes on the way it came: in x, in y, and in one of them strictly.
      const Point &p = cuts[i - 1].at, &q = cuts[i].at;
      ASSERT_NE(p, q);
      ASSERT_TRUE(p.x == q.x || (p.x < q.x) == (a.x < b.x));
      ASSERT_TRUE(p.y == q.y || (p.y < q.y) == (a.y < b.y));
    }
  }
}

TEST(Meetings, doNotDependOnTheOrderOfTheEdges) {
  Random random(2);
  for (int round = 0; round < 60; ++round) {
    std::vector<Path> paths = soup(random, 60);
    const Settling settling = Settling::of_round(round % 3 == 0 ? 1 : round % 3 == 1 ? 5 : 40);
    Strands strands = strands_of(paths);
    const auto cuts = sorted_cuts(strands, meetings(strands, settling));
    for (std::size_t i = paths.size(); i > 1; --i)
      std::swap(paths[i - 1], paths[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    for (Path& path : paths)
      if (random.one_in(2)) std::reverse(path.begin(), path.end());
    Strands shuffled = strands_of(paths);
    ASSERT_EQ(sorted_cuts(shuffled, meetings(shuffled, settling)), cuts);
  }
}

TEST(Meetings, ofTheFirstRoundAreAllCrossingsRoundedToNearest) {
  // Brute force: every pair of edges, by rationals.
  Random random(3);
  for (int round = 0; round < 30; ++round) {
    Strands strands = strands_of(soup(random, 40));
    std::vector<CutOfEdge> expected;
    const auto edges = edges_of(strands);
    const auto& points = strands.points;
    for (const std::uint32_t i : edges) {
      const auto add = [&](const Point& at) {
        if (at != points[i] && at != points[i + 1]) expected.push_back(cut_of(points[i], points[i + 1], at));
      };
      for (const std::uint32_t j : edges) {
        const auto x = verify::intersection_of_segments(points[i], points[i + 1], points[j], points[j + 1]);
        if (x) add({verify::round_to_nearest(x->x), verify::round_to_nearest(x->y)});
        if (x || i == j) continue;
        // None, or a stretch in common: ends of j on i.
        for (const Point& p : {points[j], points[j + 1]})
          if (verify::squared_distance(verify::RationalPoint(p), points[i], points[i + 1]) == 0) add(p);
      }
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    auto found = sorted_cuts(strands, meetings(strands));
    found.erase(std::unique(found.begin(), found.end()), found.end());  // of repeated edges
    ASSERT_EQ(found, expected);
  }
}

TEST(Meetings, laterRoundsSettleAtAVertexThatIsNear) {
  // The end (1, ulp) of one edge is just above the other edge: it becomes the meeting.
  const double ulp = 0x1p-52;
  const std::vector<Path> paths = {{{0, 0}, {2, 0}}, {{1, -1}, {1, ulp}}};
  Strands strands = strands_of(paths);
  EXPECT_EQ(meetings(strands).size(), 2u);  // a new vertex (1, 0), in both
  const auto settled = meetings(strands, Settling::of_round(2));
  // (1, ulp) is not in the box of the edge from (0, 0) to (2, 0): a new vertex again.
  EXPECT_EQ(settled.size(), 2u);
  Strands slanted = strands_of({{{0, -ulp}, {2, 2 * ulp}}, {{1, -1}, {1, ulp}}});
  const auto at_end = meetings(slanted, Settling::of_round(2));
  ASSERT_EQ(at_end.size(), 1u);
  EXPECT_EQ(at_end[0].edge, 0u);
  EXPECT_EQ(at_end[0].at, (Point{1, ulp}));
}

TEST(Meetings, aThrowingCheckpointEndsTheSearch) {
  Strands strands = strands_of({{{0, 0}, {4, 0}}, {{2, -1}, {2, 1}}});
  struct Stop {};
  EXPECT_THROW(find_meetings(strands, Grouping::by_strand, {}, [] { throw Stop{}; }), Stop);
}

}  // namespace
}  // namespace oblast::internal::noding
