// Boxes that contain points of others, compared with brute force.
#include "plane/enclosing_boxes.h"

#include <gtest/gtest.h>

#include "generators/random.h"
#include "support/usual_tuning.h"

namespace oblast::internal {
namespace {

struct Boxes {
  std::vector<Box> boxes;
  std::vector<Point> points;

  void add(double x, double y, double width, double height) {
    boxes.push_back({x, y, x + width, y + height});
    points.push_back({x, y + height / 2});
  }
};

void expect_right(const Boxes& b) {
  const std::size_t n = b.boxes.size();
  Array<std::uint8_t> encloses(n, 0), enclosed(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j && b.boxes[i].meets(Box::of(b.points[j], b.points[j]))) encloses[i] = enclosed[j] = 1;
  const Enclosure found = find_enclosing(b.boxes, b.points);
  if (testing::usual_tuning) {
    EXPECT_EQ(found.encloses, encloses);
    EXPECT_EQ(found.enclosed, enclosed);
  }
  for (std::size_t i = 0; i < n; ++i) {  // more may be said to
    EXPECT_GE(found.encloses[i], encloses[i]) << i;
    EXPECT_GE(found.enclosed[i], enclosed[i]) << i;
  }
}

TEST(EnclosingBoxes, areThoseOfEveryPair) {
  generators::Random random(3);
  for (const int n : {0, 1, 2, 7, 100, 2000}) {
    Boxes scattered, beside_a_large_one;
    for (int i = 0; i < n; ++i) {
      const double x = random.unit(), y = random.unit(), width = random.unit() / (n + 1), height = random.unit() / n;
      scattered.add(x, y, width, height);
      beside_a_large_one.add(x + 0.5, y, width, height);
    }
    if (n > 0) beside_a_large_one.add(0, 0, 1, 1);
    expect_right(scattered);
    expect_right(beside_a_large_one);
  }
}

TEST(EnclosingBoxes, mayBePointsOrLieInOneLine) {
  Boxes line, copies, huge;
  for (int i = 0; i < 50; ++i) {
    line.add(i, 7, 1, 0);
    if (i < 10) copies.add(1, 1, 0, 0);
    huge.add(i % 2 ? -1e150 : 1e150 / (i + 1), 1e-150 * i, 1e149, 1e-150);
  }
  expect_right(line);
  expect_right(copies);
  expect_right(huge);
}

TEST(EnclosingBoxes, thatCoverEachOtherAllCount) {
  // Nested boxes, a thousand deep: testing every pair would take a million comparisons.
  Boxes nested;
  for (int i = 0; i < 1000; ++i) nested.add(-i, -i, 2 * i + 1, 2 * i + 1);
  const Enclosure found = find_enclosing(nested.boxes, nested.points);
  EXPECT_EQ(found.encloses, Array<std::uint8_t>(1000, 1));
  EXPECT_EQ(found.enclosed, Array<std::uint8_t>(1000, 1));
}

}  // namespace
}  // namespace oblast::internal
