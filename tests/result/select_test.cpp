// The truth tables, and the selection as their edge.
#include "result/select.h"

#include <gtest/gtest.h>

#include "support/graph_of.h"
#include "verify/text_regions.h"

namespace oblast::testing {
namespace {

constexpr Operation operations[] = {Operation::intersection, Operation::unite, Operation::difference,
                                    Operation::symmetric_difference};
constexpr FillRule rules[] = {FillRule::polygons(), FillRule::at_least(2), FillRule::even_odd(),
                              FillRule::nonzero(),  FillRule::positive(),  FillRule::negative()};

TEST(Select, operationsByTheirTables) {
  //                            (in A, in B): (0, 0), (0, 1), (1, 0), (1, 1)
  constexpr bool tables[4][4] = {
      {false, false, false, true}, {false, true, true, true}, {false, false, true, false}, {false, true, true, false}};
  for (int o = 0; o < 4; ++o)
    for (int in = 0; in < 4; ++in) EXPECT_EQ(admits(operations[o], in & 2, in & 1), tables[o][in]) << o << " " << in;
}

TEST(Select, fillRulesByTheirTables) {
  //                   winding number: -2, -1, 0, 1, 2, 3
  constexpr bool tables[6][6] = {{false, false, false, true, true, true}, {false, false, false, false, true, true},
                                 {false, true, false, true, false, true}, {true, true, false, true, true, true},
                                 {false, false, false, true, true, true}, {true, true, false, false, false, false}};
  for (int r = 0; r < 6; ++r)
    for (int w = -2; w <= 3; ++w) EXPECT_EQ(is_inside(rules[r], w), tables[r][w + 2]) << r << " " << w;
}

TEST(Select, takesChainsWithTheResultOnJustOneSideAndDirectsThem) {
  ChainGraph graph = graph_of(verify::regions_of("0 0, 4 0, 4 4"), nullptr, {});
  ASSERT_EQ(graph.chains.size(), 1u);
  for (int code = 0; code < 5 * 5 * 5 * 5; ++code) {
    const Winding right{code % 5 - 2, code / 5 % 5 - 2}, change{code / 25 % 5 - 2, code / 125 - 2};
    graph.chains[0].change = change;
    for (const Operation operation : operations) {
      for (const FillRule& rule : rules) {
        Options options;
        options.fill_a = rule;
        const auto inside = [&](Winding w) {
          return admits(operation, is_inside(rule, w.a), is_inside(options.fill_b, w.b));
        };
        const bool on_left = inside(right + change), on_right = inside(right);
        const Descriptor expected = on_left == on_right ? none : on_left ? forward(0) : opposite(forward(0));
        ASSERT_EQ(select(graph, {right}, operation, options), Selection{expected});
      }
    }
  }
}

TEST(Select, passesOverChainsThatAreNotLive) {
  ChainGraph graph = graph_of(verify::regions_of("0 0, 4 0, 4 4"), nullptr, {});
  graph.chains[0].merged_into = 7;
  EXPECT_EQ(select(graph, {Winding{}}, Operation::unite, {}), Selection{none});
}

}  // namespace
}  // namespace oblast::testing
