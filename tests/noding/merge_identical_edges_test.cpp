// Identical edges become one: sums, cancelling, parity; the winding of every edge is kept.
#include "noding/merge_identical_edges.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "generators/random.h"
#include "support/strands_of.h"

namespace oblast::internal::noding {
namespace {

using testing::box;
using testing::closed;
using testing::edges_of;
using testing::strands_of;

using EdgeKey = std::tuple<double, double, double, double>;

/// The sum of the changes of every edge, seen from its smaller end; zero sums left out.
std::map<EdgeKey, std::pair<int, int>> changes_of(const Strands& strands) {
  std::map<EdgeKey, std::pair<int, int>> sums;
  for (std::size_t s = 0; s < strands.size(); ++s) {
    for (std::uint32_t e = strands.begin(s); e + 1 < strands.ends[s]; ++e) {
      Point p = strands.points[e], q = strands.points[e + 1];
      Winding change = strands.change[s];
      if (lexicographically_less(q, p)) {
        std::swap(p, q);
        change = -change;
      }
      auto& [a, b] = sums[{p.x, p.y, q.x, q.y}];
      a += change.a;
      b += change.b;
    }
  }
  for (auto& [edge, sum] : sums) {
    const Winding w = strands.rules.reduce({sum.first, sum.second});
    sum = {w.a, w.b};
  }
  std::erase_if(sums, [](const auto& entry) { return entry.second == std::pair(0, 0); });
  return sums;
}

TEST(MergeIdenticalEdges, leavesStrandsWithoutThemAlone) {
  const Strands strands = strands_of({closed(box(0, 0, 1, 1)), closed(box(2, 0, 3, 1))}, {1, 0}, 4);
  const Strands merged = merge_identical_edges(strands);
  EXPECT_EQ(merged.points, strands.points);
  EXPECT_EQ(merged.ends, strands.ends);
  EXPECT_EQ(merged.group, strands.group);
}

TEST(MergeIdenticalEdges, oppositeEdgesCancel) {
  // Two squares with a common side: the side goes, what is left are two open strands.
  const Strands merged =
      merge_identical_edges(strands_of({closed(box(0, 0, 1, 1)), closed(box(1, 0, 2, 1))}, {1, 0}, 4));
  EXPECT_EQ(edges_of(merged).size(), 6u);
  EXPECT_EQ(changes_of(merged).count({1, 0, 1, 1}), 0u);
  for (const Group group : merged.group) EXPECT_EQ(group, 4u);
}

TEST(MergeIdenticalEdges, equalEdgesAddUp) {
  Strands strands = strands_of({{{0, 0}, {1, 1}}, {{1, 1}, {0, 0}}, {{0, 0}, {1, 1}}}, {}, 3);
  strands.change = {{1, 0}, {0, 2}, {5, 1}};
  const Strands merged = merge_identical_edges(strands);
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_EQ(merged.points.size(), 2u);
  EXPECT_EQ(merged.points[0], (Point{0, 0}));  // the direction of the first
  EXPECT_EQ(merged.change[0], (Winding{6, -1}));
  EXPECT_EQ(merged.group[0], 3u);  // what is known of the first is known of it
}

TEST(MergeIdenticalEdges, underParityTwoOfADirectionCancel) {
  Strands strands = strands_of({{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}});
  strands.change = {{1, 1}, {1, 1}};
  strands.rules = {true, false};
  const Strands merged = merge_identical_edges(strands);
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_EQ(merged.change[0], (Winding{0, 2}));
  EXPECT_TRUE(merged.rules.parity_a);
  strands.rules = {true, true};
  EXPECT_EQ(merge_identical_edges(strands).size(), 0u);
}

TEST(MergeIdenticalEdges, keepsTheWindingOfEveryEdge) {
  generators::Random random(1);
  for (int round = 0; round < 300; ++round) {
    std::vector<testing::Path> paths;
    for (int i = random.between(2, 8); i > 0; --i) {
      testing::Path ring;
      while (static_cast<int>(ring.size()) < 3 + i % 3) {
        const Point p{1.0 * random.below(3), 1.0 * random.below(3)};
        if (ring.empty() || (p != ring.back() && p != ring.front())) ring.push_back(p);
      }
      paths.push_back(closed(ring));
    }
    Strands strands = strands_of(paths);
    for (Winding& change : strands.change) change = {random.one_in(2) ? 1 : -1, random.between(-1, 2)};
    strands.rules = {random.one_in(2), random.one_in(2)};
    const Strands merged = merge_identical_edges(strands);
    ASSERT_EQ(changes_of(merged), changes_of(strands));
    ASSERT_EQ(edges_of(merged).size(), changes_of(strands).size());  // each once, none of change 0
    ASSERT_EQ(merge_identical_edges(merged).points, merged.points);  // once is enough
    for (std::size_t s = 0; s < merged.size(); ++s) ASSERT_GE(merged.ends[s] - merged.begin(s), 2u);
  }
}

/// Squares of side 1 in a row, `gap` apart; one in `repeated` of them twice.
Strands squares(int count, double gap, int repeated) {
  std::vector<testing::Path> paths;
  for (int i = 0; i < count; ++i) {
    const double x = i * (1 + gap);
    for (int copies = i % repeated == repeated - 1 ? 2 : 1; copies > 0; --copies)
      paths.push_back(closed(box(x, 0, x + 1, 1)));
  }
  return strands_of(paths, {1, 0}, 1);
}

TEST(MergeIdenticalEdges, ofManyEdgesAllWhereSomeAreRepeated) {
  // Neighbours with a common side are many, one copy in fifty is few: they are found in different ways.
  for (const auto& [gap, repeated] : {std::pair(0.0, 1 << 30), std::pair(0.5, 50)}) {
    const Strands strands = squares(20000, gap, repeated), merged = merge_identical_edges(strands);
    EXPECT_EQ(changes_of(merged), changes_of(strands));
    EXPECT_EQ(edges_of(merged).size(), changes_of(strands).size());
    EXPECT_LT(merged.points.size(), strands.points.size());
  }
}

TEST(MergeIdenticalEdges, ofManyCopiesOfFewEdgesWhereverTheyLie) {
  // The sample is drawn by the bits of the coordinates: of four different edges it may contain none.
  for (int place = 0; place < 20; ++place) {
    const double x = 0.013 + 0.1 * place;
    const std::vector<std::vector<Point>> copies(4000,
                                                 closed({{x, x}, {x + 1.3, x + 0.1}, {x + 1.1, x + 1.7}, {x, x + 1}}));
    EXPECT_FALSE(identical_edges(strands_of(copies), Seek::if_frequent).empty()) << place;
  }
}

TEST(MergeIdenticalEdges, ofManyEdgesNoneRepeated) {
  const Strands strands = squares(20000, 0.5, 1 << 30);
  EXPECT_TRUE(identical_edges(strands).empty());
}

}  // namespace
}  // namespace oblast::internal::noding
