// The worked example of the paper (figures 4 to 9), step by step. Coordinates are ours, chosen so that the vertices
// have the paper's numbers: a5 is the vertex of A's hole where the outer contour of B touches itself, at B2 and B9.
//
//     A ----------------.--------- B0      A: a square with a hole
//     |   ___           |    ___/   |      B: a triangle, and a hole in it that touches its corner
//     |  /   \        _/|  /        |
//     | |     x =====       |---|   |      x = a5 = B2 = B9
//     |  \___/          |  \___     |
//     +-----------------+---------- B11    The expected contours, vertex by vertex: tests/cases/papers.
#include <gtest/gtest.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <array>

#include "engines/leonov_nikitin/label.h"
#include "engines/leonov_nikitin/tables.h"
#include "engines_vatti/noded_graph.h"
#include "result/select.h"

namespace oblast::internal {
namespace {

using namespace leonov_nikitin;

RegionSet region_a() {
  return {{{0, 0}, {16, 0}, {16, 16}, {0, 16}, {9, 5}, {5, 4}, {3, 8}, {5, 12}, {9, 11}, {10, 8}}, {4, 10}, {2}};
}

RegionSet region_b() { return {{{22, 14}, {10, 8}, {14, 9}, {19, 9}, {19, 7}, {14, 7}, {10, 8}, {22, 2}}, {8}, {1}}; }

constexpr Point x{10, 8};

std::uint32_t node_at(const ChainGraph& graph, const Point& p) {
  for (std::uint32_t node = 0; node < graph.node_count(); ++node)
    if (graph.point(graph.node_vertex[node]) == p) return node;
  ADD_FAILURE() << "no node at " << p.x << ", " << p.y;
  return 0;
}

/// Label of an edge of `of`, from the windings of both regions; region sets have windings 0 and 1 only.
EdgeLabel label_of(Winding right, Winding change, Region of) {
  const std::int32_t own = of == Region::a ? change.a : change.b, other = of == Region::a ? change.b : change.a;
  const std::int32_t other_right = of == Region::a ? right.b : right.a;
  if (other == 0) return other_right != 0 ? EdgeLabel::inside : EdgeLabel::outside;
  return own == other ? EdgeLabel::shared1 : EdgeLabel::shared2;
}

// Figure 6: three intersection vertices, a5, B2 and B9, have six descriptors in L(x), sorted by angle.
TEST(WorkedExample, connectivityListOfX) {
  const RegionSet b = region_b();
  const ChainGraph graph = noded_graph(region_a(), &b, FillRule::polygons());
  const auto list = graph.list(node_at(graph, x));
  ASSERT_EQ(list.size(), 6u);
  std::vector<Point> ends;
  for (const Descriptor d : list) ends.push_back(graph.point(graph.next_vertex(d)));
  const std::vector<Point> by_angle{{16, 11}, {9, 11}, {9, 5}, {16, 5}, {14, 7}, {14, 9}};  // counter-clockwise
  const auto first = std::find(ends.begin(), ends.end(), by_angle[0]);
  ASSERT_NE(first, ends.end());
  std::rotate(ends.begin(), first, ends.end());
  EXPECT_EQ(ends, by_angle);
}

// Figure 8: how the chains at x are marked.
TEST(WorkedExample, labelsOfChains) {
  const RegionSet b = region_b();
  const ChainGraph graph = noded_graph(region_a(), &b, FillRule::polygons());
  const LargeArray<Winding> right = label(graph);
  const auto label_towards = [&](const Point& p, Region of) {
    for (const Descriptor d : graph.list(node_at(graph, x)))
      if (graph.point(graph.next_vertex(d)) == p)
        return label_of(right[chain_of(d)], graph.chains[chain_of(d)].change, of);
    ADD_FAILURE() << "no chain towards " << p.x << ", " << p.y;
    return EdgeLabel::shared1;
  };
  EXPECT_EQ(label_towards({9, 5}, Region::a), EdgeLabel::outside);
  EXPECT_EQ(label_towards({9, 11}, Region::a), EdgeLabel::outside);
  for (const Point p : {Point{16, 11}, Point{14, 9}, Point{14, 7}, Point{16, 5}})
    EXPECT_EQ(label_towards(p, Region::b), EdgeLabel::inside) << p.x << ", " << p.y;
}

// Table 3 selects what stage 4 selects.
TEST(WorkedExample, tableThreeSelectsTheSameChains) {
  const RegionSet b = region_b();
  const ChainGraph graph = noded_graph(region_a(), &b, FillRule::polygons());
  const LargeArray<Winding> right = label(graph);
  std::size_t selected = 0;
  for (const Operation op :
       {Operation::intersection, Operation::unite, Operation::difference, Operation::symmetric_difference}) {
    const Selection selection = select(graph, right, op, {});
    for (std::uint32_t c = 0; c < graph.chains.size(); ++c) {
      if (!graph.is_live(c)) continue;
      const Winding change = graph.chains[c].change;
      const Region of = change.a != 0 ? Region::a : Region::b;
      // An edge of a region set has its region on its left; a strand may run the other way.
      const bool runs_on = (of == Region::a ? change.a : change.b) > 0;
      const Direction direction = edge_rule(op, label_of(right[c], change, of), of);
      const Descriptor edge = runs_on ? forward(c) : opposite(forward(c));
      const Descriptor expected = direction == Direction::none      ? none
                                  : direction == Direction::forward ? edge
                                                                    : opposite(edge);
      EXPECT_EQ(selection[c], expected) << "operation " << static_cast<int>(op) << ", chain " << c;
      selected += expected != none;
    }
  }
  EXPECT_GT(selected, 0u);
}

/// Numbers of outer (counter-clockwise) and inner contours.
std::array<int, 2> outer_and_inner(const RegionSet& set) {
  std::array<int, 2> counts{};
  const RegionView view = set;
  for (std::size_t c = 0; c < view.contour_count(); ++c) {
    const auto contour = view.contour(c);
    double area = 0;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point &p = contour[i], &q = contour[(i + 1) % contour.size()];
      area += p.x * q.y - q.x * p.y;
    }
    ++counts[area > 0 ? 0 : 1];
  }
  return counts;
}

class EnginesOnWorkedExample : public ::testing::TestWithParam<Engine> {};

// Figure 9: "The union consists of one outer and two inner contours, difference and intersection of two outer
// contours, the symmetric difference of three outer contours."
TEST_P(EnginesOnWorkedExample, contoursAreAsStated) {
  Options options;
  options.engine = GetParam();
  options.contours = ContourConvention::leonov_nikitin;
  const auto counts = [&](Operation op) { return outer_and_inner(overlay(region_a(), region_b(), op, options)); };
  using Counts = std::array<int, 2>;
  EXPECT_EQ(counts(Operation::unite), (Counts{1, 2}));
  EXPECT_EQ(counts(Operation::difference), (Counts{2, 0}));
  EXPECT_EQ(counts(Operation::intersection), (Counts{2, 0}));
  EXPECT_EQ(counts(Operation::symmetric_difference), (Counts{3, 0}));
  EXPECT_EQ(outer_and_inner(unite(region_b(), options)), (Counts{1, 0}));  // one contour that touches itself

  // With ogc every ring is simple. A less B closes around A's hole at x, so the hole is a separate ring.
  options.contours = ContourConvention::ogc;
  EXPECT_EQ(counts(Operation::unite), (Counts{1, 2}));
  EXPECT_EQ(counts(Operation::difference), (Counts{2, 1}));
  EXPECT_EQ(counts(Operation::intersection), (Counts{2, 0}));
  EXPECT_EQ(counts(Operation::symmetric_difference), (Counts{3, 1}));
  EXPECT_EQ(outer_and_inner(unite(region_b(), options)), (Counts{1, 1}));
}

std::string engine_name(const ::testing::TestParamInfo<Engine>& tested) {
  static constexpr const char* names[] = {"leonov_nikitin", "vatti", "skvortsov"};
  return names[static_cast<int>(tested.param)];
}

INSTANTIATE_TEST_SUITE_P(All, EnginesOnWorkedExample,
                         ::testing::Values(Engine::leonov_nikitin, Engine::vatti, Engine::skvortsov), engine_name);

}  // namespace
}  // namespace oblast::internal
