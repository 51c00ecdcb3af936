// Delaunay triangulations of all kinds of points, verified exactly.
#include "triangulation/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "generators/random.h"
#include "support/check_mesh.h"
#include "triangulation/spatial_order.h"

namespace oblast::testing {
namespace {

using generators::Random;
using triangulation::delaunay;
using triangulation::Mesh;

std::size_t distinct(const std::vector<Point>& points) {
  std::set<std::pair<double, double>> set;
  for (const Point& p : points) set.insert({p.x, p.y});
  return set.size();
}

void expect_delaunay(const std::vector<Point>& points) {
  const Mesh mesh = delaunay(points);
  const auto fault = check_mesh(mesh, {});
  ASSERT_FALSE(fault) << *fault;
  ASSERT_EQ(mesh.points.size(), distinct(points));
  ASSERT_EQ(mesh.vertex_of.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(mesh.points[mesh.vertex_of[i]], points[i]);
}

std::vector<Point> uniform(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points(n);
  for (Point& p : points) p = {random.unit(), random.unit()};
  return points;
}

TEST(Delaunay, ofFewPoints) {
  expect_delaunay({});
  expect_delaunay({{1, 2}});
  expect_delaunay({{1, 2}, {1, 2}});
  expect_delaunay({{1, 2}, {3, 4}});
  expect_delaunay({{0, 0}, {1, 0}, {0, 1}});
  expect_delaunay({{0, 0}, {0, 1}, {1, 0}});
  expect_delaunay({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  expect_delaunay({{0, 0}, {2, 0}, {1, 0}, {1, 0}, {1, 1}});
  expect_delaunay({{0.0, 0.0}, {-0.0, 0.0}, {1, 0}, {0, 1}, {-0.0, -0.0}});
}

TEST(Delaunay, ofCollinearPointsHasNoTriangles) {
  for (const Point direction : {Point{1, 0}, Point{0, 1}, Point{3, 7}, Point{-1, 1}}) {
    std::vector<Point> points;
    for (int i = 0; i < 100; ++i) points.push_back({direction.x * (i * 37 % 50), direction.y * (i * 37 % 50)});
    expect_delaunay(points);
    EXPECT_TRUE(delaunay(points).triangles.empty());
    points.push_back({-1, -5});
    expect_delaunay(points);
    EXPECT_FALSE(delaunay(points).triangles.empty());
  }
}

TEST(Delaunay, ofUniformPoints) {
  for (const std::size_t n : {5, 17, 100, 1000, 20000}) expect_delaunay(uniform(n, n));
}

TEST(Delaunay, ofLattices) {
  Random random(5);
  for (int round = 0; round < 300; ++round) {
    const int size = random.between(1, 12);
    std::vector<Point> points(static_cast<std::size_t>(random.between(1, 200)));
    for (Point& p : points) p = {static_cast<double>(random.below(size)), static_cast<double>(random.below(size))};
    expect_delaunay(points);
  }
  std::vector<Point> full;
  for (int x = 0; x < 60; ++x)
    for (int y = 0; y < 60; ++y) full.push_back({x * 0.1, y * 0.1});
  expect_delaunay(full);
}

TEST(Delaunay, ofCocircularPoints) {
  std::vector<Point> points{{0, 0}};
  for (const auto& [x, y] : {std::pair{25, 0}, {24, 7}, {20, 15}, {15, 20}, {7, 24}, {0, 25}})
    for (const int sx : {-1, 1})
      for (const int sy : {-1, 1}) points.push_back({static_cast<double>(sx * x), static_cast<double>(sy * y)});
  expect_delaunay(points);
  points.erase(points.begin());
  expect_delaunay(points);
}

TEST(Delaunay, ofPointsOnCurves) {
  std::vector<Point> circle, parabola, spiral;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * 0.00314;
    circle.push_back({std::cos(t), std::sin(t)});
    parabola.push_back({t, t * t});
    spiral.push_back({t * std::cos(20 * t), t * std::sin(20 * t)});
  }
  for (int i = 0; i < 1000; ++i) parabola.push_back({3 - i * 0.001, 100});
  expect_delaunay(circle);
  expect_delaunay(parabola);
  expect_delaunay(spiral);
}

TEST(Delaunay, ofAllMagnitudes) {
  Random random(6);
  for (int round = 0; round < 100; ++round) {
    const int low = random.between(-300, 290), high = random.between(low, 299);
    std::vector<Point> points;
    for (int i = 0; i < 60; ++i) {
      const auto coordinate = [&] {
        const double x = std::ldexp(1 + random.unit(), random.between(low, high));
        return random.one_in(10) ? 0 : random.one_in(2) ? x : -x;
      };
      points.push_back({coordinate(), coordinate()});
    }
    expect_delaunay(points);
  }
}

TEST(SpatialOrder, isAPermutation) {
  for (const std::size_t n : {0, 1, 2, 15, 16, 1000, 5000}) {
    auto order = triangulation::spatial_order(uniform(n, n + 1));
    std::sort(order.begin(), order.end());
    for (std::uint32_t i = 0; i < n; ++i) ASSERT_EQ(order[i], i);
    ASSERT_EQ(order.size(), n);
  }
}

double length_of(const std::vector<Point>& points, std::span<const std::uint32_t> order) {
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    length += std::hypot(points[order[i]].x - points[order[i - 1]].x, points[order[i]].y - points[order[i - 1]].y);
  return length;
}

TEST(SpatialOrder, isShort) {
  // A curve of Hilbert through n points of the unit square is about 0.92 sqrt(n) long; the rounds with a
  // quarter, a sixteenth, ... of the points double that.
  const auto points = uniform(100000, 9);
  EXPECT_LT(length_of(points, triangulation::spatial_order(points)), 2.2 * std::sqrt(100000.0));
}

TEST(SpatialOrder, goesOnInsideClusters) {
  // The same points shrunk into a corner, far below the resolution of the first grid.
  auto points = uniform(100000, 9);
  for (Point& p : points) p = {p.x * 0x1p-40, p.y * 0x1p-40};
  points.push_back({1, 1});
  const auto order = triangulation::spatial_order(points);
  EXPECT_LT(length_of(points, order), 2 * std::sqrt(2.0) + 2.2 * std::sqrt(100000.0) * 0x1p-40);
}

}  // namespace
}  // namespace oblast::testing
