// The in-circle test against whole numbers of any size: signs, laws, and the whole domain.
#include "exact/in_circle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators/random.h"
#include "support/exact_signs.h"

namespace oblast::testing {
using namespace internal;
namespace {

using exact::in_circle;
using generators::Random;

constexpr int even_permutations[12][4] = {{0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {0, 2, 3, 1},
                                          {2, 3, 0, 1}, {3, 0, 2, 1}, {0, 3, 1, 2}, {3, 1, 0, 2},
                                          {1, 0, 3, 2}, {1, 3, 2, 0}, {3, 2, 1, 0}, {2, 1, 3, 0}};

void expect_exact(const Point (&p)[4]) {
  const int expected = exact_in_circle(p[0], p[1], p[2], p[3]);
  for (const auto& i : even_permutations) {
    ASSERT_EQ(in_circle(p[i[0]], p[i[1]], p[i[2]], p[i[3]]), expected);
    ASSERT_EQ(in_circle(p[i[1]], p[i[0]], p[i[2]], p[i[3]]), -expected);
  }
}

TEST(InCircle, knowsInsideOnAndOutside) {
  const Point a{0, 0}, b{2, 0}, c{2, 2};
  EXPECT_EQ(in_circle(a, b, c, {1, 1}), 1);
  EXPECT_EQ(in_circle(a, b, c, {0, 2}), 0);
  EXPECT_EQ(in_circle(a, b, c, {0, std::nextafter(2.0, 0.0)}), 1);
  EXPECT_EQ(in_circle(a, b, c, {0, std::nextafter(2.0, 3.0)}), -1);
  EXPECT_EQ(in_circle(a, b, c, {-1, 2}), -1);
}

TEST(InCircle, isExactOnLattices) {
  Random random(1);
  for (int round = 0; round < 20000; ++round) {
    Point p[4];
    const double scale = std::ldexp(1.0, random.between(-30, 40));
    const int size = random.one_in(2) ? 4 : 1000;
    for (Point& q : p) q = {random.between(-size, size) * scale, random.between(-size, size) * scale};
    expect_exact(p);
  }
}

TEST(InCircle, isExactByAnUlp) {
  Random random(2);
  const auto nudged = [&](double x) {
    for (int steps = random.below(3); steps > 0; --steps) x = std::nextafter(x, random.one_in(2) ? 1e300 : -1e300);
    return x;
  };
  for (int round = 0; round < 20000; ++round) {
    const Point centre{random.in(-100, 100), random.in(-100, 100)};
    const double radius = random.in(1e-3, 50);
    Point p[4];
    for (Point& q : p) {
      const double angle = random.below(16) * 0.39269908169872414;
      q = {nudged(centre.x + radius * std::cos(angle)), nudged(centre.y + radius * std::sin(angle))};
    }
    expect_exact(p);
  }
}

TEST(InCircle, isExactInTheWholeDomain) {
  Random random(3);
  for (int round = 0; round < 20000; ++round) {
    const int low = random.between(-300, 299),
              high = random.one_in(3) ? std::min(low + 5, 299) : random.between(low, 299);
    const auto coordinate = [&] {
      if (random.one_in(8)) return 0.0;
      const double mantissa = random.one_in(2) ? 1 + random.unit() : 1 + random.below(4) * 0.25;
      return std::ldexp(random.one_in(2) ? mantissa : -mantissa, random.between(low, high));
    };
    Point p[4];
    for (Point& q : p) q = {coordinate(), coordinate()};
    if (random.one_in(2)) p[3] = {p[0].x + p[2].x - p[1].x, p[0].y + p[2].y - p[1].y};  // often nearly a rectangle
    for (Point& q : p) {
      const auto fits = [](double x) { return x == 0 || (std::fabs(x) >= 0x1p-300 && std::fabs(x) <= 0x1p300); };
      if (!fits(q.x)) q.x = 0;
      if (!fits(q.y)) q.y = 0;
    }
    expect_exact(p);
  }
}

TEST(InCircle, isExactAtTheEndsOfTheDomain) {
  constexpr double s = 0x1p-300, l = 0x1p300;
  const double values[] = {0, s, -s, l, -l, 1, 3 * s, std::nextafter(l, 0.0), std::nextafter(s, 1.0)};
  Random random(4);
  for (int round = 0; round < 3000; ++round) {
    Point p[4];
    for (Point& q : p) q = {values[random.below(9)], values[random.below(9)]};
    expect_exact(p);
  }
}

}  // namespace
}  // namespace oblast::testing
