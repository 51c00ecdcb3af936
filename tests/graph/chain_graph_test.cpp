// The chain graph of hostile arrangements: lists in order, winding numbers that fit around every node.
#include "graph/chain_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "generators/hostile.h"
#include "support/graph_of.h"
#include "verify/predicates.h"
#include "verify/text_regions.h"

namespace oblast::testing {
namespace {

using verify::regions_of;

/// Every list counter-clockwise, each direction once: going around, the angle falls back just once.
void expect_counter_clockwise(const ChainGraph& graph, std::uint32_t node) {
  const auto list = graph.list(node);
  const Point x = graph.point(graph.node_vertex[node]);
  int falls = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Point &p = graph.point(graph.next_vertex(list[i])),
                &q = graph.point(graph.next_vertex(list[(i + 1) % list.size()]));
    if (list.size() > 1) {
      ASSERT_FALSE(verify::same_direction(x, p, q));
    }
    falls += !verify::angle_less(x, p, q);
  }
  ASSERT_EQ(falls, list.empty() ? 0 : 1);
}

/// Walking once around a node ends with the winding numbers it began with.
void expect_changes_cancel(const ChainGraph& graph, std::uint32_t node) {
  Winding sum;
  for (const Descriptor d : graph.list(node)) sum = sum + graph.change(d);
  ASSERT_TRUE(graph.strands.rules.reduce(sum).is_zero()) << sum.a << " " << sum.b;
}

void expect_consistent(const ChainGraph& graph) {
  std::vector<int> listed(graph.chains.size() * 2, 0);
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    expect_counter_clockwise(graph, node);
    expect_changes_cancel(graph, node);
    for (const Descriptor d : graph.list(node)) {
      ++listed[d];
      ASSERT_EQ(graph.start_node(d), node);
      ASSERT_EQ(graph.point(graph.start_vertex(d)), graph.point(graph.node_vertex[node]));
    }
  }
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    const Chain& chain = graph.chains[c];
    const int expected = graph.is_live(c) && !chain.is_loop() ? 1 : 0;
    ASSERT_EQ(listed[forward(c)], expected);
    ASSERT_EQ(listed[opposite(forward(c))], expected);
    // Between its ends a chain passes through no node.
    for (std::uint32_t v = chain.first + 1; v < chain.last; ++v)
      ASSERT_FALSE(graph.strands.flags[v] & noding::node_flag);
    const Chain& kept = graph.chains[chain.merged_into];
    ASSERT_EQ(kept.merged_into, chain.merged_into);
    if (chain.merged_into == c) continue;
    ASSERT_EQ(std::minmax(chain.from, chain.to), std::minmax(kept.from, kept.to));
    ASSERT_EQ(chain.last - chain.first, 1u);
  }
}

TEST(ChainGraph, isConsistentForHostileInput) {
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(std::string(generator.name) + ", seed " + std::to_string(seed));
      const auto operands = generator.make(seed, 80);
      const RegionView b = operands.b;
      for (const FillRule rule : {FillRule::polygons(), FillRule::even_odd()}) {
        Options options;
        options.fill_a = options.fill_b = rule;
        expect_consistent(graph_of(operands.a, &b, options));
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(ChainGraph, aContourThatMeetsNothingIsALoop) {
  const ChainGraph graph = graph_of(regions_of("0 0, 4 0, 4 4 | 9 9, 12 9, 12 12"), nullptr, {});
  ASSERT_EQ(graph.chains.size(), 2u);
  EXPECT_TRUE(graph.chains[0].is_loop() && graph.chains[1].is_loop());
  EXPECT_EQ(graph.node_count(), 0u);
}

TEST(ChainGraph, hasAsManyElementsAsThereAreMeetings) {
  const ChainGraph graph =
      graph_of(regions_of("0 0, 4 0, 5 1, 5 3, 4 4, 0 4 | 2 2, 9 2, 9 9, 8 10, 3 10, 2 9"), nullptr, {});
  // Two crossings, and where the two contours begin; the chains between them.
  EXPECT_EQ(graph.node_count(), 4u);
  EXPECT_EQ(graph.chains.size(), 6u);
  std::vector<std::size_t> degrees;
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) degrees.push_back(graph.list(node).size());
  std::sort(degrees.begin(), degrees.end());
  EXPECT_EQ(degrees, (std::vector<std::size_t>{2, 2, 4, 4}));
}

TEST(ChainGraph, edgesThatCoincideAfterNodingAreOne) {
  // The long side of one square holds the side of the other, which runs back.
  const ChainGraph graph = graph_of(regions_of("0 0, 4 0, 4 4, 0 4 | 4 1, 6 1, 6 3, 4 3"), nullptr, {});
  const auto dead = static_cast<int>(graph.chains.size()) -
                    static_cast<int>(std::count_if(graph.chains.begin(), graph.chains.end(), [&](const Chain& c) {
                      return graph.is_live(static_cast<std::uint32_t>(&c - graph.chains.data()));
                    }));
  EXPECT_EQ(dead, 2);
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) EXPECT_EQ(graph.list(node).size(), 2u);
}

}  // namespace
}  // namespace oblast::testing
