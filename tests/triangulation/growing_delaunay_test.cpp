// Triangulations that grow by batches: each is Delaunay, and what a batch changed is what it says.
#include "triangulation/growing_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "generators/random.h"
#include "support/check_mesh.h"

namespace oblast::testing {
namespace {

using generators::Random;
using triangulation::GrowingDelaunay;
using triangulation::Mesh;
using triangulation::Triangle;
using triangulation::triangle_of;

/// Points of a grid in random order, with repetitions: many are equal, collinear and cocircular.
std::vector<Point> some_points(Random& random, std::size_t count, int side) {
  std::vector<Point> points(count);
  for (Point& p : points) p = {static_cast<double>(random.below(side)), static_cast<double>(random.below(side))};
  return points;
}

bool same(const Triangle& a, const Triangle& b) {
  return std::equal(a.vertex, a.vertex + 3, b.vertex) && std::equal(a.twin, a.twin + 3, b.twin);
}

/// The vertices alone.
bool same_corners(const Triangle& a, const Triangle& b) { return std::equal(a.vertex, a.vertex + 3, b.vertex); }

/// check_mesh wants marks of 0, as they are between algorithms.
void expect_delaunay(Mesh mesh) {
  for (Triangle& t : mesh.triangles) t.mark = 0;
  const auto fault = check_mesh(mesh, {});
  ASSERT_FALSE(fault) << *fault;
}

TEST(GrowingDelaunay, SaysWhatABatchChanged) {
  for (int seed = 1; seed <= 20; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Mesh mesh;
    GrowingDelaunay growing(mesh);
    std::vector<Point> given = some_points(random, 200, 15 + seed);
    ASSERT_TRUE(growing.add(given));
    EXPECT_TRUE(growing.changed().empty());
    for (const std::size_t count : {100U, 1U, 0U, 50U, 3U}) {
      const Mesh before = mesh;
      const std::vector<Point> batch = some_points(random, count, 15 + seed);
      given.insert(given.end(), batch.begin(), batch.end());
      ASSERT_TRUE(growing.add(batch));
      expect_delaunay(mesh);
      ASSERT_EQ(mesh.vertex_of.size(), given.size());
      for (std::size_t i = 0; i < given.size(); ++i) ASSERT_EQ(mesh.points[mesh.vertex_of[i]], given[i]);
      std::vector<std::uint32_t> changed(growing.changed().begin(), growing.changed().end());
      std::sort(changed.begin(), changed.end());
      ASSERT_EQ(std::adjacent_find(changed.begin(), changed.end()), changed.end());
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const bool is_new = t >= before.triangles.size();
        if (is_new || !same_corners(mesh.triangles[t], before.triangles[t])) {
          EXPECT_TRUE(std::binary_search(changed.begin(), changed.end(), t));
          for (const auto h : mesh.triangles[t].twin) EXPECT_TRUE(growing.is_near_change(triangle_of(h)));
        }
        if (!growing.is_near_change(t)) {
          EXPECT_TRUE(!is_new && same(mesh.triangles[t], before.triangles[t]));
        }
      }
    }
  }
}

TEST(GrowingDelaunay, LeavesWhatIsFarAway) {
  Random random(7);
  Mesh mesh;
  GrowingDelaunay growing(mesh);
  ASSERT_TRUE(growing.add(some_points(random, 5000, 1000)));
  ASSERT_TRUE(growing.add(std::vector<Point>{{500.5, 500.25}}));
  std::size_t near = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) near += growing.is_near_change(t);
  EXPECT_GT(near, 0U);
  EXPECT_LT(near, 100U);
}

TEST(GrowingDelaunay, RefusesAFirstBatchOnALine) {
  Mesh mesh;
  GrowingDelaunay growing(mesh);
  EXPECT_FALSE(growing.add(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_TRUE(mesh.points.empty());
}

}  // namespace
}  // namespace oblast::testing
