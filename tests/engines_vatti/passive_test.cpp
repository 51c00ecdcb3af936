// Passive contours: all that are far from others are found, none that is near another is.
#include "engines/vatti/passive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engines/leonov_nikitin/label.h"
#include "engines/vatti/label.h"
#include "engines_vatti/noded_graph.h"
#include "generators/random.h"
#include "generators/soup.h"
#include "noding/monotone_runs.h"
#include "support/usual_tuning.h"

namespace oblast::internal {
namespace {

using namespace generators;

std::vector<std::uint32_t> live_chains(const ChainGraph& graph) {
  std::vector<std::uint32_t> live;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c)
    if (graph.is_live(c)) live.push_back(c);
  return live;
}

Box box_of(const ChainGraph& graph, std::uint32_t chain) {
  Box box = Box::of(graph.point(graph.chains[chain].first), graph.point(graph.chains[chain].first));
  for (std::uint32_t v = graph.chains[chain].first; v <= graph.chains[chain].last; ++v) {
    const Point& p = graph.point(v);
    box = {std::min(box.x0, p.x), std::min(box.y0, p.y), std::max(box.x1, p.x), std::max(box.y1, p.y)};
  }
  return box;
}

TEST(Passive, contoursFarApartAreAllPassive) {
  RegionSet set;
  for (int i = 0; i < 50; ++i)
    for (int j = 0; j < 50; ++j) {
      const Ring ring = rectangle(4 * i, 4 * j, 4 * i + 0.5, 4 * j + 0.5);
      add_polygon(set, (i + j) % 2 ? ring : reversed(ring));
    }
  const ChainGraph graph = noded_graph(set, nullptr, FillRule::nonzero());
  LargeArray<Winding> right(graph.chains.size(), Winding{7, 7});
  const auto active = vatti::label_passive(graph, live_chains(graph), right);
  if (!testing::usual_tuning) GTEST_SKIP() << "may look coarsely";
  EXPECT_TRUE(active.empty());
  EXPECT_EQ(right, leonov_nikitin::label(graph));
}

TEST(Passive, contoursInOrAcrossOthersAreActive) {
  RegionSet set;
  add_polygon(set, rectangle(0, 0, 10, 10));
  add_polygon(set, rectangle(4, 4, 5, 5));     // inside
  add_polygon(set, rectangle(20, 0, 30, 10));  // across the next
  add_polygon(set, rectangle(25, 5, 35, 15));
  add_polygon(set, {{50, 0}, {60, 10}, {50, 10}});  // boxes alone meet
  add_polygon(set, {{52, 0}, {60, 0}, {60, 6}});
  add_polygon(set, rectangle(100, 100, 101, 101));  // passive
  const ChainGraph graph = noded_graph(set, nullptr, FillRule::nonzero());
  LargeArray<Winding> right(graph.chains.size(), Winding{});
  const std::vector<std::uint32_t> live = live_chains(graph);
  const auto active = vatti::label_passive(graph, live, right);
  ASSERT_EQ(active.size(), live.size() - 1);
  for (const std::uint32_t c : active) EXPECT_LT(box_of(graph, c).x0, 100);
}

TEST(Passive, noBoxOfAPassiveContourMeetsAnother) {
  std::size_t passive_count = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    RegionSet set;
    for (int i = 0; i < 300; ++i) {
      const double size = random.one_in(30) ? random.in(0, 0.4) : random.in(0, 0.02);
      const double x = random.unit(), y = random.unit();
      const Ring ring = {{x, y}, {x + size, y + size / 2}, {x, y + size}};
      add_polygon(set, random.one_in(2) ? ring : reversed(ring));
    }
    const ChainGraph graph = noded_graph(set, nullptr, FillRule::nonzero());
    const std::vector<std::uint32_t> live = live_chains(graph);
    LargeArray<Winding> right(graph.chains.size(), Winding{});
    const auto active = vatti::label_passive(graph, live, right);
    const LargeArray<Winding> expected = leonov_nikitin::label(graph);
    for (const std::uint32_t c : live) {
      if (std::binary_search(active.begin(), active.end(), c)) continue;
      ++passive_count;
      EXPECT_EQ(right[c], expected[c]);
      for (const std::uint32_t d : live) ASSERT_TRUE(c == d || !box_of(graph, c).meets(box_of(graph, d)));
    }
    const LargeArray<Winding> all = vatti::label(graph);
    for (const std::uint32_t c : live) EXPECT_EQ(all[c], expected[c]);
  }
  if (testing::usual_tuning) {
    EXPECT_GT(passive_count, 1000u);
  }
}

}  // namespace
}  // namespace oblast::internal
