// Labels by the scan line: equal to those of Leonov and Nikitin on every noded graph.
#include "engines/vatti/label.h"

#include <gtest/gtest.h>

#include "engines/leonov_nikitin/label.h"
#include "engines_vatti/noded_graph.h"
#include "generators/hostile.h"
#include "generators/random.h"
#include "generators/soup.h"

namespace oblast::internal {
namespace {

using namespace generators;

/// Live chains labelled; a chain whose labels differ fails the test.
std::size_t compare(const ChainGraph& graph, const std::string& what) {
  const LargeArray<Winding> scanned = vatti::label(graph), carried = leonov_nikitin::label(graph);
  std::size_t live = 0;
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    if (!graph.is_live(c)) continue;
    ++live;
    EXPECT_TRUE(scanned[c] == carried[c]) << what << ", chain " << c << ": (" << scanned[c].a << ", " << scanned[c].b
                                          << ") instead of (" << carried[c].a << ", " << carried[c].b << ")";
    if (!(scanned[c] == carried[c])) break;
  }
  return live;
}

class HostileLabels : public ::testing::TestWithParam<HostileGenerator> {};

TEST_P(HostileLabels, areThoseOfLeonovAndNikitin) {
  std::size_t live = 0;
  const std::pair<int, std::uint64_t> cases[] = {{8, 100}, {20, 100}, {60, 30}, {150, 4}};
  for (const auto& [size, seeds] : cases) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Operands operands = GetParam().make(seed, size);
      for (const FillRule& rule : {FillRule::polygons(), FillRule::nonzero()}) {
        live +=
            compare(noded_graph(operands.a, &operands.b, rule),
                    std::string(GetParam().name) + " seed " + std::to_string(seed) + " size " + std::to_string(size));
        ASSERT_FALSE(HasFailure());
      }
    }
  }
  EXPECT_GT(live, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Generators, HostileLabels,
                         ::testing::ValuesIn(hostile_generators().begin(), hostile_generators().end()),
                         [](const auto& generator) { return std::string(generator.param.name); });

/// The label of the chain that lies along y = `y` and runs over x = `x`.
Winding below_line(const ChainGraph& graph, const LargeArray<Winding>& right, double x, double y) {
  for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
    if (!graph.is_live(c)) continue;
    for (std::uint32_t v = graph.chains[c].first; v < graph.chains[c].last; ++v) {
      const Point p = graph.point(v), q = graph.point(v + 1);
      if (p.y != y || q.y != y || std::min(p.x, q.x) > x || std::max(p.x, q.x) < x) continue;
      return p.x < q.x ? right[c] : right[c] + graph.chains[c].change;
    }
  }
  ADD_FAILURE() << "no chain at " << x << ", " << y;
  return {};
}

TEST(Label, nestedContoursOfBothOperands) {
  RegionSet a, b;
  add_polygon(a, rectangle(0, 0, 10, 10));
  add_polygon(a, rectangle(1, 1, 9, 9));
  add_polygon(b, rectangle(2, 2, 8, 8));
  add_polygon(b, rectangle(20, 0, 22, 2));  // passive
  const ChainGraph graph = noded_graph(a, &b, FillRule::nonzero());
  const LargeArray<Winding> right = vatti::label(graph);
  EXPECT_EQ(below_line(graph, right, 5, 0), (Winding{0, 0}));
  EXPECT_EQ(below_line(graph, right, 5, 1), (Winding{1, 0}));
  EXPECT_EQ(below_line(graph, right, 5, 2), (Winding{2, 0}));
  EXPECT_EQ(below_line(graph, right, 5, 8), (Winding{2, 1}));
  EXPECT_EQ(below_line(graph, right, 5, 9), (Winding{2, 0}));
  EXPECT_EQ(below_line(graph, right, 5, 10), (Winding{1, 0}));
  EXPECT_EQ(below_line(graph, right, 21, 0), (Winding{0, 0}));
  EXPECT_EQ(below_line(graph, right, 21, 2), (Winding{0, 1}));
}

TEST(Label, clockwisePassiveContoursHaveNegativeInsides) {
  RegionSet a;
  for (int i = 0; i < 10; ++i) add_polygon(a, reversed(rectangle(3 * i, 0, 3 * i + 1, 1)));
  const ChainGraph graph = noded_graph(a, nullptr, FillRule::nonzero());
  const LargeArray<Winding> right = vatti::label(graph);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(below_line(graph, right, 3 * i + 0.5, 0), (Winding{0, 0}));
    EXPECT_EQ(below_line(graph, right, 3 * i + 0.5, 1), (Winding{-1, 0}));
  }
}

TEST(Label, nothingIsLabelledInAnEmptyGraph) { EXPECT_TRUE(vatti::label(ChainGraph{}).empty()); }

TEST(Label, doesNotReadTheConnectivityLists) {
  const Operands operands = stars(3, 200);
  ChainGraph graph = noded_graph(operands.a, &operands.b, FillRule::nonzero());
  const LargeArray<Winding> with = vatti::label(graph);
  graph.lists.clear();
  graph.list_ends.clear();
  EXPECT_EQ(vatti::label(graph), with);
}

TEST(Label, deepNestingNeedsNoDeepStack) {
  RegionSet a;
  constexpr int depth = 20000;
  for (int i = 0; i < depth; ++i) add_polygon(a, rectangle(i, i, 2 * depth - i, 2 * depth - i));
  const ChainGraph graph = noded_graph(a, nullptr, FillRule::nonzero());
  const LargeArray<Winding> right = vatti::label(graph);
  for (const int i : {0, 1, depth / 2, depth - 1}) EXPECT_EQ(below_line(graph, right, depth, i), (Winding{i, 0}));
}

}  // namespace
}  // namespace oblast::internal
