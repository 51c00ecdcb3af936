// Walks close, use every selected chain once, and are divided (or not) where the result touches itself.
#include "result/link.h"

#include <gtest/gtest.h>

#include <set>

#include "generators/hostile.h"
#include "support/graph_of.h"

namespace oblast::testing {
namespace {

void expect_linked(const Linked& l, ContourConvention convention) {
  std::vector<int> taken(l.graph.chains.size(), 0);
  for (std::size_t c = 0; c < l.contours.ends.size(); ++c) {
    const auto contour = l.contours.contour(c);
    ASSERT_FALSE(contour.empty());
    std::set<std::uint32_t> nodes;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Descriptor d = contour[i], next = contour[(i + 1) % contour.size()];
      ASSERT_EQ(l.selection[chain_of(d)], d);  // the result on its left
      ASSERT_EQ(l.contours.walk_of_chain[chain_of(d)], l.contours.walk[c]);
      ++taken[chain_of(d)];
      if (l.graph.chains[chain_of(d)].is_loop()) {
        ASSERT_EQ(contour.size(), 1u);
        continue;
      }
      ASSERT_EQ(l.graph.end_node(d), l.graph.start_node(next));
      const bool fresh = nodes.insert(l.graph.start_node(d)).second;
      ASSERT_TRUE(fresh || convention == ContourConvention::leonov_nikitin) << "a contour visits a node twice";
    }
  }
  for (std::size_t c = 0; c < taken.size(); ++c) ASSERT_EQ(taken[c], l.selection[c] != none ? 1 : 0);
}

TEST(Link, closesEveryWalkOfHostileInput) {
  for (const auto& generator : generators::hostile_generators()) {
    SCOPED_TRACE(generator.name);
    const auto operands = generator.make(3, 80);
    for (const Operation operation : {Operation::unite, Operation::symmetric_difference}) {
      Options options;
      options.contours = ContourConvention::ogc;
      const Linked ogc = linked_of(operands.a, operands.b, operation, options);
      expect_linked(ogc, options.contours);
      options.contours = ContourConvention::leonov_nikitin;
      const Linked hugging = linked_of(operands.a, operands.b, operation, options);
      expect_linked(hugging, options.contours);
      if (HasFatalFailure()) return;
      // One contour per walk. With ogc the same walks are divided.
      EXPECT_EQ(hugging.contours.ends.size(), hugging.contours.walk_count);
      EXPECT_EQ(ogc.contours.walk_count, hugging.contours.walk_count);
      EXPECT_GE(ogc.contours.ends.size(), hugging.contours.ends.size());
    }
  }
}

struct Counts {
  std::size_t contours;
  std::uint32_t walks;
};

void expect_counts(const Question& question, Counts ogc, Counts hugging) {
  for (const auto convention : {ContourConvention::ogc, ContourConvention::leonov_nikitin}) {
    Question q = question;
    q.options.contours = convention;
    const Linked l = linked_of(q);
    const Counts& expected = convention == ContourConvention::ogc ? ogc : hugging;
    EXPECT_EQ(l.contours.ends.size(), expected.contours);
    EXPECT_EQ(l.contours.walk_count, expected.walks);
  }
}

TEST(Link, conventionsDifferWhereAHoleIsPinched) {
  const std::string square = "0 0, 4 0, 4 4, 0 4";
  // A hole that touches the outer contour in one vertex: a shell and a hole, or one contour.
  expect_counts({square, "2 0, 3 2, 1 2", Operation::difference}, {2, 1}, {1, 1});
  // Two squares that touch at a corner: two walks by either convention.
  expect_counts({square, "4 4, 6 4, 6 6, 4 6", Operation::unite}, {2, 2}, {2, 2});
  // Two holes that touch: the interior between them has two sectors there.
  expect_counts({square, "1 1, 2 1, 2 2, 1 2 | 2 2, 3 2, 3 3, 2 3", Operation::difference}, {3, 2}, {2, 2});
  // Nothing touches.
  expect_counts({square, "1 1, 2 1, 2 2, 1 2", Operation::difference}, {2, 2}, {2, 2});
}

}  // namespace
}  // namespace oblast::testing
