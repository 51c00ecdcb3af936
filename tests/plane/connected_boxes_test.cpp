// Connected boxes, compared with brute force, and crowded boxes that do not meet.
#include "plane/connected_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <span>

#include "base/disjoint_sets.h"
#include "generators/random.h"
#include "support/usual_tuning.h"

namespace oblast::internal {
namespace {

using generators::Random;

/// By box, the smallest box it is connected with.
std::vector<std::uint32_t> smallest_connected(std::span<const Box> boxes) {
  DisjointSets sets(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      if (boxes[i].meets(boxes[j])) sets.unite(i, j);
  std::vector<std::uint32_t> smallest;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) smallest.push_back(sets.find(i));
  return smallest;
}

/// The same from what was found.
std::vector<std::uint32_t> smallest_of(const ConnectedBoxes& connected) {
  std::map<std::uint32_t, std::uint32_t> first;
  std::vector<std::uint32_t> smallest;
  for (std::uint32_t i = 0; i < connected.component.size(); ++i)
    smallest.push_back(first.try_emplace(connected.component[i], i).first->second);
  return smallest;
}

void expect_order_of_all(const ConnectedBoxes& connected, std::size_t count) {
  LargeArray<std::uint32_t> sorted = connected.order, all(count);
  std::iota(all.begin(), all.end(), 0U);
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, all);
}

TEST(ConnectedBoxes, asBruteForceFindsThem) {
  Random random(1);
  for (int round = 0; round < 400; ++round) {
    LargeArray<Box> boxes;
    const int side = random.between(2, 60), largest = random.between(0, 6);
    for (int i = random.between(1, 300); i > 0; --i) {
      const double x = random.below(side), y = random.below(side);
      boxes.push_back({x, y, x + random.between(0, largest), y + random.between(0, largest)});
    }
    const ConnectedBoxes connected = connected_boxes(boxes);
    expect_order_of_all(connected, boxes.size());
    const auto found = smallest_of(connected), expected = smallest_connected(boxes);
    if (testing::usual_tuning) {
      ASSERT_EQ(found, expected) << "round " << round;
    } else {  // what is connected is together; more may be
      for (std::uint32_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(found[i], found[expected[i]]) << "round " << round;
    }
  }
}

TEST(ConnectedBoxes, noneAndOne) {
  EXPECT_TRUE(connected_boxes({}).order.empty());
  const Box box{0, 0, 1, 1};
  EXPECT_EQ(connected_boxes({box}).component, LargeArray<std::uint32_t>(1, 0));
}

TEST(ConnectedBoxes, ofManyNothingMeets) {
  LargeArray<Box> boxes;
  for (int x = 0; x < 200; ++x)
    for (int y = 0; y < 200; ++y) boxes.push_back({1.0 * x, 1.0 * y, x + 0.5, y + 0.5});
  const ConnectedBoxes connected = connected_boxes(boxes);
  EXPECT_EQ(std::set(connected.component.begin(), connected.component.end()).size(), boxes.size());
}

TEST(ConnectedBoxes, ofManyAllHangTogether) {
  // Neighbours touch; the last one lies apart.
  LargeArray<Box> boxes;
  for (int x = 0; x < 300; ++x)
    for (int y = 0; y < 300; ++y) boxes.push_back({1.0 * x, 1.0 * y, x + 1.0, y + 1.0});
  boxes.push_back({400, 400, 401, 401});
  const ConnectedBoxes connected = connected_boxes(boxes);
  EXPECT_EQ(std::set(connected.component.begin(), connected.component.end()).size(), 2u);
  EXPECT_NE(connected.component.front(), connected.component.back());
}

TEST(ConnectedBoxes, thoseThatMeetAreNeverParted) {
  // A comb of long bars that do not meet, and bars across it far away: boxes of the tree lie upon each other.
  LargeArray<Box> boxes;
  for (int i = 0; i < 3000; ++i) {
    const double length = i % 2 == 0 ? 1e6 : 1;
    boxes.push_back({-length, 10.0 * i, length, 10.0 * i + 1});
  }
  const ConnectedBoxes comb = connected_boxes(boxes);
  for (std::size_t i = 0; i < 3000; ++i)
    boxes.push_back({10.0 * static_cast<double>(i), -5, 10.0 * static_cast<double>(i) + 1, 1e6});
  const ConnectedBoxes crossed = connected_boxes(boxes);
  EXPECT_GE(std::set(comb.component.begin(), comb.component.end()).size(), 1u);
  const std::vector<std::uint32_t> smallest = smallest_connected(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(crossed.component[i], crossed.component[smallest[i]]);
}

}  // namespace
}  // namespace oblast::internal
