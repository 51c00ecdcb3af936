// The active edge list against a sorted vector.
#include "engines/vatti/active_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "generators/random.h"

namespace oblast::internal::vatti {
namespace {

/// A horizontal edge from x = 0 to x = 1, all vertices of which are known.
ActiveEdge at_height(double y) { return {{0, y}, {1, y}, 0, 1, 0, 0, {}}; }

TEST(ActiveEdges, keepTheirOrder) {
  const std::vector<Point> points(1);
  ActiveEdges active(points);
  generators::Random random(5);
  std::vector<std::pair<double, Slot>> expected;  // from below to above
  std::size_t most = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool growing = i % 4000 < 2500;
    if (growing || expected.empty()) {
      const double y = random.unit();
      const Slot below = active.find_below({0.5, y});
      const auto place = std::lower_bound(expected.begin(), expected.end(), std::pair(y, Slot{0}));
      ASSERT_EQ(below, place == expected.begin() ? ground : std::prev(place)->second);
      expected.insert(place, {y, active.insert_above(below, at_height(y))});
    } else {
      const auto gone = expected.begin() + random.below(static_cast<int>(expected.size()));
      active.erase(gone->second);
      expected.erase(gone);
    }
    most = std::max(most, expected.size());
  }
  EXPECT_GT(most, 2000u);
  Slot slot = ground;
  for (const auto& [y, expected_slot] : expected) {
    EXPECT_EQ(active.below(active.above(slot)), slot);
    slot = active.above(slot);
    EXPECT_EQ(slot, expected_slot);
    EXPECT_EQ(active[slot].a.y, y);
  }
  EXPECT_EQ(active.above(slot), none);
}

TEST(ActiveEdges, walkTheirBoundsWithTheScanLine) {
  const std::vector<Point> points = {{0, 0}, {1, 5}, {2, 0}, {3, 5}};
  ActiveEdges active(points);
  const Slot slot = active.insert_above(ground, {points[0], points[1], 1, 1, 3, 0, {}});
  EXPECT_EQ(active.find_below({0.5, 2}), ground);
  EXPECT_EQ(active.find_below({1.5, 3}), slot);
  EXPECT_EQ(active[slot].vertex, 2u);
  EXPECT_EQ(active.find_below({2.5, 2}), ground);
  EXPECT_EQ(active[slot].vertex, 3u);
}

TEST(ActiveEdges, sortedInsertionsStayQuick) {
  // Each from the one before, all from below to above: a plain tree would be a list of a million.
  const std::vector<Point> points(1);
  ActiveEdges active(points);
  Slot slot = ground;
  constexpr int count = 1000000;
  for (int i = 0; i < count; ++i) slot = active.insert_above(slot, at_height(i));
  generators::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const int y = random.below(count - 1);
    const Slot below = active.find_below({0.5, y + 0.5});
    ASSERT_EQ(active[below].a.y, y);
  }
}

}  // namespace
}  // namespace oblast::internal::vatti
