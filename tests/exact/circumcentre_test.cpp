// The circumcentre of three points against exact rationals: rounded to nearest, and the same bits for any order of the
// points and any three points of one circle.
#include "exact/circumcentre.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "generators/random.h"
#include "support/exact_signs.h"
#include "support/nearest_double.h"

namespace oblast::testing {
using namespace internal;
namespace {

using exact::circumcentre;
using generators::Random;
using Rational = boost::multiprecision::cpp_rational;

void expect_right(const Point& a, const Point& b, const Point& c) {
  const Point p = circumcentre(a, b, c);
  for (const Point& q : {circumcentre(a, c, b), circumcentre(b, a, c), circumcentre(b, c, a), circumcentre(c, a, b),
                         circumcentre(c, b, a)})
    ASSERT_EQ(p, q);
  const Rational bx = Rational(b.x) - Rational(a.x), by = Rational(b.y) - Rational(a.y);
  const Rational cx = Rational(c.x) - Rational(a.x), cy = Rational(c.y) - Rational(a.y);
  const Rational d = 2 * (bx * cy - by * cx), bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  expect_nearest(p.x, Rational(a.x) + (cy * bb - by * cc) / d);
  expect_nearest(p.y, Rational(a.y) + (bx * cc - cx * bb) / d);
}

/// Checks those of `count` drawn triangles that are none of collinear points; they must be many.
template <class Draw>
void expect_right_often(int count, int least, const Draw& draw) {
  int found = 0;
  for (int round = 0; round < count; ++round) {
    Point p[3] = {draw(), draw(), draw()};
    if (exact_orientation(p[0], p[1], p[2]) == 0) continue;
    ++found;
    expect_right(p[0], p[1], p[2]);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GE(found, least);
}

TEST(Circumcentre, ofSimpleTriangles) {
  EXPECT_EQ(circumcentre({0, 0}, {2, 0}, {0, 2}), (Point{1, 1}));
  EXPECT_EQ(circumcentre({3, 4}, {-3, 4}, {4, -3}), (Point{0, 0}));
  EXPECT_EQ(circumcentre({0, 0}, {1, 0}, {0.5, 1}), (Point{0.5, 0.375}));
}

TEST(Circumcentre, isNearestAtRandom) {
  Random random(1);
  expect_right_often(3000, 2900, [&] { return Point{random.in(-180, 180), random.in(-90, 90)}; });
}

TEST(Circumcentre, isNearestOnALattice) {
  Random random(2);
  expect_right_often(3000, 2000, [&] { return Point{random.between(-9, 9) / 1.0, random.between(-9, 9) / 1.0}; });
}

TEST(Circumcentre, isNearestOfAlmostCollinearPoints) {
  Random random(3);
  expect_right_often(3000, 1000, [&] {
    const double x = random.in(0, 9);
    double y = x * 0.75 + 1;
    for (int steps = random.below(4); steps > 0; --steps) y = std::nextafter(y, random.one_in(2) ? 99.0 : -99.0);
    return Point{x, y};
  });
}

TEST(Circumcentre, breaksTiesToEven) {
  Random random(4);
  expect_right_often(4000, 1000, [&] {
    return Point{1 + random.between(-4, 4) * 0x1p-52, 1 + random.between(-4, 4) * 0x1p-52};
  });
}

TEST(Circumcentre, isNearestNearTheEndsOfTheDomain) {
  Random random(5);
  for (const int exponent : {-298, 290}) {
    expect_right_often(500, 400, [&] {
      return Point{std::ldexp(random.between(-9, 9), exponent), std::ldexp(random.between(-9, 9), exponent)};
    });
  }
}

TEST(Circumcentre, isOnePointForAllOfACircle) {
  // Points of the circle with the radius 65 around (1/8, 1/4).
  const Point centre{0.125, 0.25};
  const double legs[][2] = {{16, 63}, {25, 60}, {33, 56}, {39, 52}, {52, 39}, {56, 33}, {60, 25}, {63, 16}};
  Random random(6);
  const auto draw = [&] {
    const auto& leg = legs[random.below(8)];
    return Point{centre.x + (random.one_in(2) ? 1 : -1) * leg[0], centre.y + (random.one_in(2) ? 1 : -1) * leg[1]};
  };
  for (int round = 0; round < 500; ++round) {
    const Point a = draw(), b = draw(), c = draw();
    if (exact_orientation(a, b, c) != 0) {
      EXPECT_EQ(circumcentre(a, b, c), centre);
    }
  }
}

}  // namespace
}  // namespace oblast::testing
