// A tree of changing boxes, compared with brute force.
#include "plane/box_tree.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "generators/random.h"

namespace oblast::internal::noding {
namespace {

TEST(BoxTree, ofNothing) {
  const BoxTree tree({});
  EXPECT_TRUE(tree.for_each_near({0, 0, 1, 1}, [](std::uint32_t) { return false; }));
}

TEST(BoxTree, stopsWhenTold) {
  const std::vector<Box> boxes(7, Box{0, 0, 1, 1});
  int visits = 0;
  EXPECT_FALSE(BoxTree(boxes).for_each_near({1, 1, 2, 2}, [&](std::uint32_t) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

TEST(BoxTree, findsWhatMeetsABoxWhileBoxesChange) {
  generators::Random random(7);
  const auto box = [&] {
    const Point p{random.in(0, 100), random.in(0, 100)};
    return Box::of(p, {p.x + random.in(0, 5), p.y + random.in(0, 5)});
  };
  for (const std::uint32_t size : {1U, 4U, 5U, 16U, 17U, 300U}) {
    std::vector<Box> start(size);
    for (Box& b : start) b = box();
    BoxTree tree(start);
    std::vector<std::optional<Box>> boxes(start.begin(), start.end());
    for (int change = 0; change < 200; ++change) {
      const auto i = static_cast<std::uint32_t>(random.in(0, size));
      if (change % 3 == 0) {
        tree.remove(i);
        boxes[i].reset();
      } else {
        boxes[i] = box();
        tree.replace(i, *boxes[i]);
      }
      const Box looked_for = box();
      std::vector<bool> expected(size), found(size);
      for (std::uint32_t k = 0; k < size; ++k) expected[k] = boxes[k] && boxes[k]->meets(looked_for);
      EXPECT_TRUE(tree.for_each_near(looked_for, [&](std::uint32_t k) {
        EXPECT_FALSE(found[k]);
        found[k] = true;
        return true;
      }));
      ASSERT_EQ(found, expected) << size << ' ' << change;
    }
  }
}

}  // namespace
}  // namespace oblast::internal::noding
