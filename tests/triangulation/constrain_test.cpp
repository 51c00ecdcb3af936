// Constraints in triangulations: hand-made pockets, random pockets, and refused input.
#include "triangulation/constrain.h"

#include <gtest/gtest.h>
#include <oblast/error.h>

#include "exact/orientation.h"
#include "generators/random.h"
#include "support/check_mesh.h"
#include "triangulation/delaunay.h"

namespace oblast::testing {
namespace {

using exact::orientation;
using generators::Random;
using triangulation::Constraint;
using triangulation::delaunay;
using triangulation::HalfEdge;
using triangulation::Mesh;

void expect_constrained(const std::vector<Point>& points, std::vector<Constraint> constraints) {
  Mesh mesh = delaunay(points);
  for (Constraint& c : constraints) c = {mesh.vertex_of[c.from], mesh.vertex_of[c.to]};
  const auto sides = constrain(mesh, constraints);
  const auto fault = check_mesh(mesh, constraints);
  ASSERT_FALSE(fault) << *fault;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    ASSERT_EQ(mesh.origin(sides[k]), constraints[k].from);
    ASSERT_EQ(mesh.target(sides[k]), constraints[k].to);
  }
}

/// They share a point that is not an end of both, or a vertex lies inside one of them.
bool meet_badly(const Point& a, const Point& b, const Point& c, const Point& d) {
  const bool shared = a == c || a == d || b == c || b == d;
  const int p = orientation(a, b, c), q = orientation(a, b, d), r = orientation(c, d, a), s = orientation(c, d, b);
  if (p == 0 && q == 0) return true;  // collinear: refused here for simplicity
  if (shared) return false;
  return p * q <= 0 && r * s <= 0;
}

TEST(Constrain, aLongSideThroughMany) {
  //   0 ------------------ 1 with points close above and below
  std::vector<Point> points{{0, 0}, {100, 0}};
  for (int i = 1; i < 100; ++i) {
    points.push_back({static_cast<double>(i), 0.3 + (i * 7 % 5) * 0.4});
    points.push_back({i - 0.5, -0.2 - (i * 3 % 7) * 0.3});
  }
  expect_constrained(points, {{0, 1}});
  expect_constrained(points, {{1, 0}, {0, 1}});
}

TEST(Constrain, pastAConvexArc) {
  // All sides crossed end in one far vertex: the case in which choosing the best vertex anew each time is quadratic.
  std::vector<Point> points{{-1000, 0}, {1000, 0}, {0, 1500}};
  for (int i = -1000; i <= 1000; ++i) points.push_back({i * 0.5, -1 - i * i * 1e-5});
  expect_constrained(points, {{0, 1}});
}

TEST(Constrain, withSidesThatDangle) {
  // Spikes that end just before the constraint, from both sides; their sides are constraints already.
  std::vector<Point> points{{0, 0}, {40, 0}};
  std::vector<Constraint> constraints;
  for (int i = 1; i < 20; ++i) {
    const double x = 2.0 * i, up = i % 2 ? 1 : -1;
    const auto tip = static_cast<std::uint32_t>(points.size());
    points.push_back({x, up * 0.01});
    points.push_back({x + 0.1, up * 30});
    constraints.push_back({tip, tip + 1});
  }
  constraints.push_back({0, 1});
  expect_constrained(points, constraints);
  std::swap(constraints.front(), constraints.back());
  expect_constrained(points, constraints);
}

TEST(Constrain, spokesOfAHub) {
  std::vector<Point> points{{0, 0}};
  std::vector<Constraint> constraints;
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double angle = i * 0.0062831, length = random.in(1, 100);
    points.push_back({length * std::cos(angle), length * std::sin(angle)});
    constraints.push_back({0, static_cast<std::uint32_t>(points.size() - 1)});
  }
  expect_constrained(points, constraints);
}

TEST(Constrain, randomSegments) {
  Random random(7);
  for (int round = 0; round < 400; ++round) {
    const bool lattice = random.one_in(2);
    std::vector<Point> points(static_cast<std::size_t>(random.between(4, 60)));
    for (Point& p : points)
      p = lattice ? Point{static_cast<double>(random.below(15)), static_cast<double>(random.below(15))}
                  : Point{random.unit(), random.unit()};
    std::vector<Constraint> constraints;
    for (int attempt = 0; attempt < 200; ++attempt) {
      const auto any = [&] { return static_cast<std::uint32_t>(random.below(static_cast<int>(points.size()))); };
      const Constraint c{any(), any()};
      const Point &a = points[c.from], &b = points[c.to];
      bool good = a != b;
      for (const Constraint& d : constraints) good = good && !meet_badly(a, b, points[d.from], points[d.to]);
      for (const Point& p : points) {
        const bool within = lexicographically_less(a, p) != lexicographically_less(b, p);
        good = good && (p == a || p == b || orientation(a, b, p) != 0 || !within);
      }
      if (good) constraints.push_back(c);
    }
    expect_constrained(points, constraints);
  }
}

TEST(Constrain, refusesCrossingsAndVerticesInside) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {1, 0.5}, {3, 1}};
  const auto constrain_all = [&](std::vector<Constraint> constraints) {
    Mesh mesh = delaunay(points);
    for (Constraint& c : constraints) c = {mesh.vertex_of[c.from], mesh.vertex_of[c.to]};
    constrain(mesh, constraints);
  };
  EXPECT_NO_THROW(constrain_all({{0, 4}, {4, 2}, {5, 6}}));
  EXPECT_THROW(constrain_all({{0, 2}}), Error);          // through vertex 4
  EXPECT_THROW(constrain_all({{1, 5}, {0, 6}}), Error);  // cross each other
  EXPECT_THROW(constrain_all({{0, 6}, {1, 5}}), Error);
}

}  // namespace
}  // namespace oblast::testing
