// The order of directions, and rough angles: where those are clear of each other they tell the same.
#include "graph/angular_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "generators/random.h"

namespace oblast::internal {
namespace {

using generators::Random;

bool clear(double angle, double other) { return std::fabs(angle - other) > rough_angle_error; }

TEST(AngularOrder, roughAnglesGrowAllAround) {
  // From just above -90 degrees, counter-clockwise.
  const Point x{5, -3};
  const std::vector<Point> around = {{1, -9}, {7, -7}, {3, 0}, {4, 4}, {0, 2}, {-5, 6}, {-2, 0}, {-3, -3}, {0, -8}};
  for (std::size_t i = 0; i + 1 < around.size(); ++i) {
    const Point p{x.x + around[i].x, x.y + around[i].y}, q{x.x + around[i + 1].x, x.y + around[i + 1].y};
    EXPECT_TRUE(angularly_less(x, p, q)) << i;
    EXPECT_FALSE(angularly_less(x, q, p)) << i;
    EXPECT_LT(rough_angle(x, p) + rough_angle_error, rough_angle(x, q)) << i;
  }
  EXPECT_GE(rough_angle(x, {x.x + 1, x.y - 1000000}), -1);
  EXPECT_LE(rough_angle(x, {x.x, x.y - 1000000}), 3);
}

TEST(AngularOrder, roughAnglesTellTheSameWhereTheyAreClear) {
  Random random(1);
  int clear_pairs = 0, near_pairs = 0;
  for (int i = 0; i < 200000; ++i) {
    // Points far from x and near it, on one line with it or almost, and of all magnitudes.
    const double size = std::ldexp(1, random.between(-40, 40));
    const auto coordinate = [&] { return random.one_in(4) ? 0.0 : size * random.between(-8, 8); };
    const Point x{coordinate(), coordinate()}, p{coordinate(), coordinate()};
    const double s = random.one_in(2) ? random.in(-2, 2) : 1 + std::ldexp(random.in(-1, 1), -random.between(20, 53));
    const Point near{x.x + s * (p.x - x.x), x.y + (p.y - x.y)}, other{coordinate(), coordinate()};
    for (const Point& q : {near, other}) {
      if (p == x || q == x) continue;
      const double p_angle = rough_angle(x, p), q_angle = rough_angle(x, q);
      if (!clear(p_angle, q_angle)) {
        ++near_pairs;
        continue;
      }
      ++clear_pairs;
      ASSERT_EQ(p_angle < q_angle, angularly_less(x, p, q));
      ASSERT_EQ(q_angle < p_angle, angularly_less(x, q, p));
    }
  }
  EXPECT_GT(clear_pairs, 100000);
  EXPECT_GT(near_pairs, 10000);
}

}  // namespace
}  // namespace oblast::internal
