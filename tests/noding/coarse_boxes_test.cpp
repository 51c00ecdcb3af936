// Coarse boxes: every two boxes that meet are visited, once, and of the others only those a cell apart.
#include "noding/coarse_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "generators/random.h"

namespace oblast::internal::noding {
namespace {

using generators::Random;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

std::vector<Run> runs_of(const std::vector<Box>& boxes) {
  std::vector<Run> runs;
  for (const Box& box : boxes) runs.push_back({box, 0, 1, any_group});
  return runs;
}

Pairs visited(const std::vector<Run>& runs) {
  CoarseBoxes coarse;
  coarse.assign(runs);
  Pairs pairs;
  coarse.for_each_pair([&](std::size_t i, std::size_t j) { pairs.push_back(std::minmax(i, j)); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Returns how many pairs were visited.
std::size_t expect_those_that_meet(const std::vector<Box>& boxes, double size) {
  const std::vector<Run> runs = runs_of(boxes);
  const Pairs pairs = visited(runs);
  EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
  // Both boxes are wider by a cell.
  const double apart = 2 * (size / 65000);
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const bool found = std::binary_search(pairs.begin(), pairs.end(), std::pair(i, j));
      if (boxes[i].meets(boxes[j])) {
        EXPECT_TRUE(found) << i << " " << j;
      } else if (!boxes[i].widened(apart).meets(boxes[j])) {
        EXPECT_FALSE(found) << i << " " << j;
      }
    }
  }
  return pairs.size();
}

TEST(CoarseBoxes, visitThoseThatMeet) {
  Random random(1);
  std::size_t pairs = 0;
  for (const std::size_t n : {1, 2, 15, 16, 17, 33, 64, 65, 300, 513}) {
    for (const double width : {0.0, 0.02, 0.3, 1.0}) {
      for (const double height : {0.0, 0.02, 0.3}) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < n; ++i) {
          const Point p{random.unit(), random.unit()};
          boxes.push_back({p.x, p.y, p.x + width * random.unit(), p.y + height * random.unit()});
        }
        pairs += expect_those_that_meet(boxes, 2);
        for (Box& box : boxes) box = box.widened(0.005);
        pairs += expect_those_that_meet(boxes, 2);
      }
    }
  }
  EXPECT_GT(pairs, 100000u);
}

TEST(CoarseBoxes, meetInEdgesAndCorners) {
  std::vector<Box> squares;
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y) squares.push_back({1.0 * x, 1.0 * y, x + 1.0, y + 1.0});
  // Of 20 x 20: side by side 2 x 19 x 20, corner to corner 2 x 19 x 19.
  EXPECT_EQ(expect_those_that_meet(squares, 20), 760u + 722u);
}

TEST(CoarseBoxes, allInOnePlaceOrOnOneLine) {
  const Box here{3, 4, 3, 4};
  EXPECT_EQ(visited(runs_of(std::vector<Box>(100, here))).size(), 4950u);
  std::vector<Box> line;
  for (int i = 0; i < 100; ++i) line.push_back({1.0 * i, 5, i + 1.0, 5});
  EXPECT_EQ(visited(runs_of(line)).size(), 99u);
}

TEST(CoarseBoxes, atTheEndsOfTheDomain) {
  const double far = 0x1p300, small = 0x1p-300;
  EXPECT_EQ(visited(runs_of({{-far, -far, far, far}, {0, 0, small, small}, {far, far, far, far}})).size(), 2u);
  EXPECT_EQ(visited(runs_of({{0, 0, small, small}, {small, 0, 2 * small, small}, {3 * small, 0, 4 * small, 0}})).size(),
            1u);
}

}  // namespace
}  // namespace oblast::internal::noding
