// The intersection of two edges against exact rationals: rounded to nearest, the same bits whichever way
// the edges are given, and inside both boxes.
#include "exact/intersection_point.h"

#include <gtest/gtest.h>
#include <oblast/domain.h>

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "generators/random.h"
#include "support/exact_signs.h"
#include "support/nearest_double.h"

namespace oblast::testing {
using namespace internal;
namespace {

using exact::intersection_point;
using generators::Random;
using Rational = boost::multiprecision::cpp_rational;

struct Edges {
  Point a, b, c, d;
};

/// They meet in one point: neither lies on one side of the other, and they are not collinear.
bool meet(const Edges& e) {
  const int c = exact_orientation(e.a, e.b, e.c), d = exact_orientation(e.a, e.b, e.d);
  const int a = exact_orientation(e.c, e.d, e.a), b = exact_orientation(e.c, e.d, e.b);
  return c * d <= 0 && a * b <= 0 && (c != 0 || d != 0) && e.a != e.b && e.c != e.d;
}

bool same_bits(const Point& p, const Point& q) {
  return std::bit_cast<std::uint64_t>(p.x) == std::bit_cast<std::uint64_t>(q.x) &&
         std::bit_cast<std::uint64_t>(p.y) == std::bit_cast<std::uint64_t>(q.y);
}

void expect_in_box(const Point& p, const Point& a, const Point& b) {
  ASSERT_TRUE(std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x));
  ASSERT_TRUE(std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y));
}

/// REQUIRES: the edges meet.
void expect_right(const Edges& e) {
  const auto& [a, b, c, d] = e;
  const Point p = intersection_point(a, b, c, d);
  for (const Point& q : {intersection_point(b, a, c, d), intersection_point(a, b, d, c), intersection_point(b, a, d, c),
                         intersection_point(c, d, a, b), intersection_point(d, c, a, b), intersection_point(c, d, b, a),
                         intersection_point(d, c, b, a)})
    ASSERT_TRUE(same_bits(p, q));
  expect_in_box(p, a, b);
  expect_in_box(p, c, d);

  const Rational rx = Rational(b.x) - Rational(a.x), ry = Rational(b.y) - Rational(a.y);
  const Rational sx = Rational(d.x) - Rational(c.x), sy = Rational(d.y) - Rational(c.y);
  const Rational wx = Rational(c.x) - Rational(a.x), wy = Rational(c.y) - Rational(a.y);
  const Rational t = (wx * sy - wy * sx) / (rx * sy - ry * sx);
  expect_nearest(p.x, Rational(a.x) + t * rx);
  expect_nearest(p.y, Rational(a.y) + t * ry);
}

/// Checks those of `count` drawn pairs that meet; they must be many.
template <class Draw>
void expect_right_often(int count, int least, const Draw& draw) {
  int met = 0;
  for (int round = 0; round < count; ++round) {
    Edges e = draw();
    for (Point* p : {&e.a, &e.b, &e.c, &e.d}) {
      if (!in_domain(p->x)) p->x = 0;
      if (!in_domain(p->y)) p->y = 0;
    }
    if (!meet(e)) continue;
    ++met;
    expect_right(e);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GE(met, least);
}

TEST(IntersectionPoint, ofSimpleEdges) {
  EXPECT_EQ(intersection_point({0, 0}, {2, 2}, {0, 2}, {2, 0}), (Point{1, 1}));
  EXPECT_EQ(intersection_point({0, 0}, {3, 0}, {1, -1}, {1, 5}), (Point{1, 0}));
  EXPECT_EQ(intersection_point({0, 0}, {1, 1}, {0, 0.5}, {1, 0}), (Point{1.0 / 3, 1.0 / 3}));
}

TEST(IntersectionPoint, isNearestAtRandom) {
  Random random(1);
  const auto point = [&] { return Point{random.in(-180, 180), random.in(-90, 90)}; };
  expect_right_often(4000, 500, [&] { return Edges{point(), point(), point(), point()}; });
}

TEST(IntersectionPoint, isNearestOfNearlyParallelEdges) {
  Random random(2);
  expect_right_often(6000, 500, [&] {
    const Point a{random.in(-9, 9), random.in(-9, 9)}, b{random.in(-9, 9), random.in(-9, 9)};
    const auto nudged = [&](double x) {
      for (int steps = random.below(4); steps > 0; --steps) x = std::nextafter(x, random.one_in(2) ? 99.0 : -99.0);
      return x;
    };
    return Edges{a, b, {nudged(a.x), nudged(a.y)}, {nudged(b.x), nudged(b.y)}};
  });
}

TEST(IntersectionPoint, breaksTiesToEven) {
  // Points half-way between two doubles: the edges of a lattice whose unit is the ulp.
  Random random(3);
  expect_right_often(6000, 300, [&] {
    const double base = random.one_in(2) ? 1 : -1;
    const auto point = [&] {
      return Point{base + random.between(-4, 4) * 0x1p-52, base + random.between(-4, 4) * 0x1p-52};
    };
    return Edges{point(), point(), point(), point()};
  });
}

TEST(IntersectionPoint, isNearestInTheWholeDomain) {
  Random random(4);
  expect_right_often(6000, 500, [&] {
    const int low = random.between(-300, 299), high = random.one_in(2) ? random.between(low, 299) : low;
    const auto coordinate = [&] {
      if (random.one_in(6)) return 0.0;
      const double mantissa = random.one_in(2) ? 1 + random.unit() : 1 + random.below(4) * 0.25;
      return std::ldexp(random.one_in(2) ? mantissa : -mantissa, random.between(low, high));
    };
    const auto point = [&] { return Point{coordinate(), coordinate()}; };
    return Edges{point(), point(), point(), point()};
  });
}

TEST(IntersectionPoint, isNearestAroundZero) {
  // Crossings whose coordinates come out below the domain: 0 or the domain's smallest.
  Random random(5);
  int zeros = 0;
  expect_right_often(4000, 300, [&] {
    const auto tiny = [&] { return std::ldexp(random.between(-4, 4), -300); };
    const auto any = [&] { return random.one_in(2) ? tiny() : random.in(-1, 1); };
    const Edges e{{tiny(), any()}, {tiny(), any()}, {any(), tiny()}, {any(), tiny()}};
    if (meet(e) && intersection_point(e.a, e.b, e.c, e.d) == Point{}) ++zeros;
    return e;
  });
  EXPECT_GT(zeros, 10);
}

TEST(IntersectionPoint, atTheEndsOfTheDomain) {
  constexpr double s = domain_smallest, l = domain_largest;
  const double values[] = {0, s, -s, l, -l, 1, 3 * s, std::nextafter(l, 0.0)};
  Random random(6);
  expect_right_often(6000, 300, [&] {
    const auto value = [&] { return values[random.below(8)]; };
    return Edges{{value(), value()}, {value(), value()}, {value(), value()}, {value(), value()}};
  });
}

}  // namespace
}  // namespace oblast::testing
