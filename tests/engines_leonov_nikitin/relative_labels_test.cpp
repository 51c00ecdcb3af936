// Labels carried in ranges of nodes side by side: one component, and many, that reach over several ranges. The scan
// line of vatti, which knows no ranges, says what they are to be.
#include "engines/leonov_nikitin/relative_labels.h"

#include <gtest/gtest.h>

#include <set>

#include "engines/leonov_nikitin/label.h"
#include "engines/vatti/label.h"
#include "engines_vatti/noded_graph.h"
#include "generators/random.h"
#include "generators/soup.h"

namespace oblast::internal {
namespace {

using generators::add_polygon;

/// A net of n horizontal and n vertical bars: 4 n^2 nodes, all connected.
void add_net(RegionSet& region, double x, double y, int n) {
  const double length = 2.0 * n + 1;
  for (int i = 0; i < n; ++i) {
    const double at = 2.0 * i + 1;
    add_polygon(region, {{x, y + at}, {x + length, y + at}, {x + length, y + at + 1}, {x, y + at + 1}});
    add_polygon(region, {{x + at, y}, {x + at + 1, y}, {x + at + 1, y + length}, {x + at, y + length}});
  }
}

void expect_same_labels(const ChainGraph& graph) {
  const LargeArray<Winding> scanned = vatti::label(graph), carried = leonov_nikitin::label(graph);
  std::size_t different = 0;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) different += graph.is_live(c) && !(scanned[c] == carried[c]);
  EXPECT_EQ(different, 0u) << "of " << graph.chains.size();
}

TEST(RelativeLabels, oneComponentReachesOverManyRanges) {
  RegionSet a, b;
  add_net(a, 0, 0, 60);
  add_net(b, 0.5, 0.25, 60);
  const ChainGraph graph = noded_graph(a, &b, FillRule::nonzero());
  ASSERT_GT(graph.node_count(), 40000u);
  EXPECT_EQ(leonov_nikitin::label_relatively(graph).component_count, 1u);
  expect_same_labels(graph);
}

TEST(RelativeLabels, manyComponentsLieInAndAroundEachOther) {
  // Nets in the meshes of a frame, and small crosses scattered over both, some within meshes.
  RegionSet a, b;
  generators::Random random(5);
  for (int i = 0; i < 6; ++i) {
    const double low = -100 - 10 * i, high = 1000 + 10 * i;
    add_polygon(i % 2 ? a : b, {{low, low}, {high, low}, {high, high}, {low, high}});
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) add_net((i + j) % 2 ? a : b, 300.0 * i, 300.0 * j, 30 + 3 * i);
  for (int i = 0; i < 3000; ++i) {
    const double x = random.in(0, 900), y = random.in(0, 900);
    add_polygon(a, {{x, y}, {x + 0.6, y}, {x + 0.6, y + 0.2}, {x, y + 0.2}});
    add_polygon(b, {{x + 0.2, y - 0.2}, {x + 0.4, y - 0.2}, {x + 0.4, y + 0.4}, {x + 0.2, y + 0.4}});
  }
  const ChainGraph graph = noded_graph(a, &b, FillRule::nonzero());
  ASSERT_GT(graph.node_count(), 30000u);
  const leonov_nikitin::RelativeLabels labels = leonov_nikitin::label_relatively(graph);
  EXPECT_GT(labels.component_count, 1000u);
  std::set<std::uint32_t> used;
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    if (graph.list(node).empty()) continue;
    used.insert(labels.component[node]);
    for (const Descriptor d : graph.list(node)) ASSERT_EQ(labels.component[graph.end_node(d)], labels.component[node]);
  }
  EXPECT_EQ(used.size(), labels.component_count);
  expect_same_labels(graph);
}

}  // namespace
}  // namespace oblast::internal
