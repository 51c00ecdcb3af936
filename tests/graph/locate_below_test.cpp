// What lies below a place against a vertical ray and exact rationals.
#include "graph/locate_below.h"

#include <gtest/gtest.h>

#include "generators/random.h"
#include "support/graph_of.h"
#include "verify/rational.h"

namespace oblast::testing {
namespace {

using generators::Random;
using verify::Rational;

/// The chain next below p, just right of it, of those named, by a look at every edge. REQUIRES: p is on none.
Below below_by_ray(const ChainGraph& graph, std::span<const std::uint32_t> chains, const Point& p) {
  Below best;
  Rational best_y, best_slope;
  for (const std::uint32_t c : chains) {
    for (std::uint32_t v = graph.chains[c].first; v < graph.chains[c].last; ++v) {
      Point a = graph.point(v), b = graph.point(v + 1);
      const bool rightward = a.x < b.x;
      if (!rightward) std::swap(a, b);
      if (!(a.x <= p.x && p.x < b.x)) continue;
      const Rational slope = (Rational(b.y) - Rational(a.y)) / (Rational(b.x) - Rational(a.x));
      const Rational y = Rational(a.y) + slope * (Rational(p.x) - Rational(a.x));
      if (y >= Rational(p.y)) continue;
      if (best.chain != none && (y < best_y || (y == best_y && slope < best_slope))) continue;
      best = {c, rightward};
      best_y = y;
      best_slope = slope;
    }
  }
  return best;
}

std::vector<std::uint32_t> live_chains(const ChainGraph& graph) {
  std::vector<std::uint32_t> chains;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c)
    if (graph.is_live(c)) chains.push_back(c);
  return chains;
}

template <class MakeVertex, class MakePlace>
void expect_same_as_ray(const MakeVertex& vertex, const MakePlace& place) {
  RegionSet set;
  for (int c = 0; c < 12; ++c) {
    for (int i = 0; i < 5; ++i) set.points.push_back(vertex());
    set.contour_ends.push_back(static_cast<std::uint32_t>(set.points.size()));
  }
  Options options;
  options.fill_a = FillRule::nonzero();
  const ChainGraph graph = graph_of(set, nullptr, options);
  const auto chains = live_chains(graph);
  std::vector<BelowQuery> queries;
  for (int i = 0; i < 60; ++i) {
    const Point p = place();
    queries.push_back({p, {p.x + 1, p.y}});
  }
  const auto answers = locate_below(graph, chains, queries);
  ASSERT_EQ(answers.size(), queries.size());
  int found = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Below expected = below_by_ray(graph, chains, queries[i].p);
    ASSERT_EQ(answers[i].chain, expected.chain) << queries[i].p.x << " " << queries[i].p.y;
    if (expected.chain == none) continue;
    ASSERT_EQ(answers[i].rightward, expected.rightward);
    ++found;
  }
  EXPECT_GT(found, 10);
}

TEST(LocateBelow, findsWhatARayFinds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    expect_same_as_ray(
        [&] {
          return Point{random.unit(), random.unit()};
        },
        [&] {
          return Point{random.unit(), random.unit()};
        });
    if (HasFatalFailure()) return;
  }
}

TEST(LocateBelow, findsWhatARayFindsOverVertices) {
  // On a lattice: vertices, vertical edges and fans straight below the places.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    expect_same_as_ray(
        [&] {
          return Point{1.0 * random.below(7), 1.0 * random.below(7)};
        },
        [&] {
          return Point{1.0 * random.below(7), random.below(8) - 0.3718281828};
        });
    if (HasFatalFailure()) return;
  }
}

TEST(LocateBelow, ofNothingIsNothing) {
  RegionSet set;
  set.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  set.contour_ends = {4};
  const ChainGraph graph = graph_of(set, nullptr, {});
  const std::uint32_t all[] = {0};
  const BelowQuery queries[] = {
      {{2, -1}, {3, -1}}, {{2, 2}, {3, 2}}, {{2, 9}, {3, 9}}, {{-1, 2}, {0, 2}}, {{4, 9}, {5, 9}}};
  const auto answers = locate_below(graph, all, queries);
  EXPECT_EQ(answers[0].chain, none);
  EXPECT_EQ(answers[1].chain, 0u);
  EXPECT_TRUE(answers[1].rightward);  // the floor of the square
  EXPECT_EQ(answers[2].chain, 0u);
  EXPECT_FALSE(answers[2].rightward);  // its ceiling
  EXPECT_EQ(answers[3].chain, none);
  EXPECT_EQ(answers[4].chain, none);  // just right of it there is nothing
  EXPECT_EQ(locate_below(graph, {}, queries)[1].chain, none);
  EXPECT_TRUE(locate_below(graph, all, {}).empty());
}

TEST(LocateBelow, theEdgeItselfMayLeaveAVertexOfTheChains) {
  // From the common vertex (0, 0): which of the edges there is next below the query's?
  RegionSet set;
  set.points = {{0, 0}, {4, -4}, {4, -2}, {0, 0}, {4, 2}, {4, 4}};
  set.contour_ends = {3, 6};
  const ChainGraph graph = graph_of(set, nullptr, {});
  const auto chains = live_chains(graph);
  const BelowQuery queries[] = {{{0, 0}, {1, 0}}, {{0, 0}, {1, 3}}, {{0, 0}, {1, -9}}, {{0, 0}, {3, 2.5}}};
  const auto answers = locate_below(graph, chains, queries);
  const auto x_of = [&](const Below& below) { return graph.point(graph.chains[below.chain].first + 1).y; };
  ASSERT_NE(answers[0].chain, none);
  EXPECT_FALSE(answers[0].rightward);  // the upper side of the lower triangle
  EXPECT_LT(x_of(answers[0]), 0);
  EXPECT_FALSE(answers[1].rightward);
  EXPECT_GT(x_of(answers[1]), 0);
  EXPECT_EQ(answers[2].chain, none);
  EXPECT_TRUE(answers[3].rightward);  // the lower side of the upper one
}

}  // namespace
}  // namespace oblast::testing
