// The orientation against whole numbers of any size: signs, laws, the whole domain.
#include "exact/orientation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/random.h"
#include "support/exact_signs.h"

namespace oblast::testing {
using namespace internal;
namespace {

using exact::orientation;
using exact::orientation_exact;
using generators::Random;

/// Checks all six orders of the points, with and without the filter, and returns the sign.
int expect_exact(const Point& a, const Point& b, const Point& c) {
  const int expected = exact_orientation(a, b, c);
  for (const auto sign : {orientation, orientation_exact}) {
    EXPECT_EQ(sign(a, b, c), expected);
    EXPECT_EQ(sign(b, c, a), expected);
    EXPECT_EQ(sign(c, a, b), expected);
    EXPECT_EQ(sign(b, a, c), -expected);
    EXPECT_EQ(sign(a, c, b), -expected);
    EXPECT_EQ(sign(c, b, a), -expected);
  }
  return expected;
}

TEST(Orientation, knowsLeftRightAndStraight) {
  const Point a{0, 0}, b{2, 1};
  EXPECT_EQ(orientation(a, b, {0, 1}), 1);
  EXPECT_EQ(orientation(a, b, {1, 0}), -1);
  EXPECT_EQ(orientation(a, b, {4, 2}), 0);
  EXPECT_EQ(orientation(a, b, {-2, -1}), 0);
  EXPECT_EQ(orientation(a, a, b), 0);
  EXPECT_EQ(orientation(a, b, {4, std::nextafter(2.0, 3.0)}), 1);
  EXPECT_EQ(orientation(a, b, {4, std::nextafter(2.0, 1.0)}), -1);
}

TEST(Orientation, isExactAroundADiagonal) {
  // The grid of doubles next to (0.5, 0.5), against a line through it: where plain arithmetic errs most.
  int straight = 0;
  for (int i = 0; i < 48; ++i) {
    for (int j = 0; j < 48; ++j) {
      const Point p{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      const int sign = expect_exact(p, {12, 12}, {24, 24});
      EXPECT_EQ(sign, p.y > p.x ? 1 : p.y < p.x ? -1 : 0);
      straight += sign == 0;
    }
  }
  EXPECT_GE(straight, 48);
}

TEST(Orientation, isExactByAnUlp) {
  Random random(1);
  int signs[3] = {};
  for (int round = 0; round < 5000; ++round) {
    const Point a{random.in(-9, 9), random.in(-9, 9)}, b{random.in(-9, 9), random.in(-9, 9)};
    const double t = random.one_in(3) ? random.in(-4, 4) : 0.5 * random.between(-4, 4);
    Point c{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    if (random.one_in(2)) c.y = std::nextafter(c.y, random.one_in(2) ? 99.0 : -99.0);
    ++signs[1 + expect_exact(a, b, c)];
  }
  for (const int count : signs) EXPECT_GT(count, 50);
}

TEST(Orientation, isExactOnLattices) {
  Random random(2);
  for (int round = 0; round < 3000; ++round) {
    const double scale = std::ldexp(1.0, random.between(-290, 290));
    const auto point = [&] { return Point{scale * random.between(-5, 5), scale * random.between(-5, 5)}; };
    expect_exact(point(), point(), point());
  }
}

TEST(Orientation, isExactInTheWholeDomain) {
  Random random(3);
  const auto coordinate = [&](int low, int high) {
    if (random.one_in(6)) return 0.0;
    const double mantissa = random.one_in(2) ? 1 + random.unit() : 1 + random.below(4) * 0.25;
    return std::ldexp(random.one_in(2) ? mantissa : -mantissa, random.between(low, high));
  };
  for (int round = 0; round < 6000; ++round) {
    const int low = random.between(-300, 299), high = random.one_in(2) ? random.between(low, 299) : low;
    Point p[3];
    for (Point& q : p) q = {coordinate(low, high), coordinate(low, high)};
    if (random.one_in(3)) p[2] = {2 * p[1].x - p[0].x, 2 * p[1].y - p[0].y};  // nearly on the line
    for (Point& q : p) {
      if (std::fabs(q.x) < 0x1p-300 || std::fabs(q.x) > 0x1p300) q.x = 0;
      if (std::fabs(q.y) < 0x1p-300 || std::fabs(q.y) > 0x1p300) q.y = 0;
    }
    expect_exact(p[0], p[1], p[2]);
  }
}

TEST(Orientation, isExactAtTheEndsOfTheDomain) {
  constexpr double s = 0x1p-300, l = 0x1p300;
  const double values[] = {0, s, -s, l, -l, 1, std::nextafter(s, 1.0), std::nextafter(l, 0.0)};
  Random random(4);
  for (int round = 0; round < 3000; ++round) {
    Point p[3];
    for (Point& q : p) q = {values[random.below(8)], values[random.below(8)]};
    expect_exact(p[0], p[1], p[2]);
  }
}

}  // namespace
}  // namespace oblast::testing
