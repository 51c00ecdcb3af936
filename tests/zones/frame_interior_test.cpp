// Boxes are within a frame if no edge meets them and they are inside.
#include "zones/frame_interior.h"

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "generators/random.h"

namespace oblast::internal::zoning {
namespace {

bool holds(const RegionSet& frame, const Box& box) {
  bool found = false;
  within_call([&] { found = FrameInterior(frame).holds(box); });
  return found;
}

TEST(FrameInterior, OfATriangle) {
  const RegionSet triangle{{{0, 0}, {8, 0}, {0, 8}}, {3}, {1}};
  EXPECT_TRUE(holds(triangle, {1, 1, 2, 2}));
  EXPECT_TRUE(holds(triangle, {1, 1, 1, 1}));
  EXPECT_TRUE(holds(triangle, {3, 3, 4, 3.9999999}));
  EXPECT_FALSE(holds(triangle, {3, 3, 4, 4}));  // a corner is on the edge
  EXPECT_FALSE(holds(triangle, {0, 1, 2, 2}));
  EXPECT_FALSE(holds(triangle, {5, 5, 6, 6}));    // in the box of the edge, but outside
  EXPECT_FALSE(holds(triangle, {-1, -1, 9, 9}));  // it holds the triangle
  EXPECT_FALSE(holds(triangle, {9, 9, 10, 10}));
}

TEST(FrameInterior, OfRingsThatAreClosedAndPointsThatAreRepeated) {
  EXPECT_TRUE(holds({{{0, 0}, {0, 0}, {9, 0}, {9, 9}, {9, 9}, {0, 9}, {0, 0}}, {7}, {1}}, {1, 1, 8, 8}));
}

TEST(FrameInterior, OfHolesAndSeveralPolygons) {
  const RegionSet with_a_hole{{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 3}, {3, 6}, {6, 6}, {6, 3}}, {4, 8}, {2}};
  EXPECT_TRUE(holds(with_a_hole, {1, 1, 2, 8}));
  EXPECT_FALSE(holds(with_a_hole, {4, 4, 5, 5}));
  EXPECT_FALSE(holds(with_a_hole, {2, 4, 7, 5}));
  const RegionSet apart{{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {5, 0}, {8, 0}, {8, 3}, {5, 3}}, {4, 8}, {1, 2}};
  EXPECT_TRUE(holds(apart, {6, 1, 7, 2}));
  EXPECT_FALSE(holds(apart, {3.5, 1, 4, 2}));
  const RegionSet twice{{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {3, 0}, {3, 3}, {0, 3}}, {4, 8}, {1, 2}};
  EXPECT_FALSE(holds(twice, {1, 1, 2, 2}));
}

// No place of a box that is held may be outside: by a hundred places of each.
TEST(FrameInterior, HoldsNothingOutside) {
  generators::Random random(5);
  int held = 0;
  for (int trial = 0; trial < 400; ++trial) {
    RegionSet frame;
    const int corners = random.between(3, 40);
    for (int i = 0; i < corners; ++i) {
      const double x = random.in(0, 10);
      frame.points.push_back({x, random.in(0, 10)});
    }
    frame.contour_ends = {static_cast<std::uint32_t>(corners)};
    frame.polygon_ends = {1};
    const double x = random.in(0, 10), y = random.in(0, 10), size = random.in(0, 2);
    const Box box{x, y, x + size, y + size};
    if (!holds(frame, box)) continue;
    ++held;
    const Locator locator(frame);
    for (int i = 0; i < 100; ++i) {
      const double px = random.in(box.x0, box.x1);
      ASSERT_EQ(locator.locate({px, random.in(box.y0, box.y1)}), Location::inside) << trial;
    }
  }
  EXPECT_GT(held, 20);
}

}  // namespace
}  // namespace oblast::internal::zoning
