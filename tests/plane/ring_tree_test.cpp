// Whether rings meet, and how deep they lie in each other, against every pair of edges.
#include "plane/ring_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/orientation.h"
#include "generators/random.h"
#include "support/strands_of.h"
#include "support/usual_tuning.h"

namespace oblast::internal::noding {
namespace {

using exact::orientation;
using testing::box;
using testing::Path;

struct Rings {
  std::vector<Point> points;
  std::vector<std::uint32_t> ends;

  explicit Rings(const std::vector<Path>& rings) {
    for (const Path& ring : rings) {
      points.insert(points.end(), ring.begin(), ring.end());
      points.push_back(ring[0]);
      ends.push_back(static_cast<std::uint32_t>(points.size()));
    }
  }
  std::uint32_t begin(std::size_t ring) const { return ring == 0 ? 0 : ends[ring - 1]; }
};

bool on_segment(const Point& p, const Point& a, const Point& b) {
  return orientation(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b)) return true;
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

bool meet_by_every_pair(const Rings& rings) {
  const auto& points = rings.points;
  for (std::size_t r = 0; r < rings.ends.size(); ++r)
    for (std::size_t s = r; s < rings.ends.size(); ++s)
      for (std::uint32_t i = rings.begin(r); i + 1 < rings.ends[r]; ++i)
        for (std::uint32_t j = std::max(rings.begin(s), i + 1); j + 1 < rings.ends[s]; ++j) {
          const Point &a = points[i], &b = points[i + 1], &c = points[j], &d = points[j + 1];
          const bool next = r == s && j == i + 1, around = r == s && i == rings.begin(r) && j + 2 == rings.ends[r];
          if (next     ? on_segment(d, a, b) || on_segment(a, c, d)
              : around ? on_segment(c, a, b) || on_segment(b, c, d)
                       : segments_meet(a, b, c, d))
            return true;
        }
  return false;
}

/// By the crossings of a ray upwards.
bool inside(const Point& p, const Rings& rings, std::size_t ring) {
  bool odd = false;
  for (std::uint32_t e = rings.begin(ring); e + 1 < rings.ends[ring]; ++e) {
    Point a = rings.points[e], b = rings.points[e + 1];
    if (a.x > b.x) std::swap(a, b);
    odd ^= a.x <= p.x && p.x < b.x && orientation(a, b, p) < 0;
  }
  return odd;
}

Array<bool> depths_by_every_edge(const Rings& rings) {
  Array<bool> odd(rings.ends.size());
  for (std::size_t r = 0; r < odd.size(); ++r)
    for (std::size_t s = 0; s < odd.size(); ++s)
      if (s != r && inside(rings.points[rings.begin(r)], rings, s)) odd[r] = !odd[r];
  return odd;
}

/// Around a centre, at angles that grow: simple wherever the radii end.
Path round(Point centre, double radius, int vertices, generators::Random& random) {
  Path ring;
  const double start = random.in(0, 6);
  for (int i = 0; i < vertices; ++i) {
    const double angle = start + 6.283185307179586 * i / vertices, r = radius * random.in(0.6, 1);
    ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
  }
  if (random.below(2) == 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

std::optional<bool> edges_meet(const Rings& rings) {
  RingTree tree;
  tree.build(rings.points, rings.ends);
  return tree.edges_meet();
}

TEST(RingTree, findsWhatMeetsOnAGrid) {
  generators::Random random(1);
  int meeting = 0, apart = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<Path> paths;
    const int count = 1 + random.below(3), size = 3 + random.below(7);
    for (int ring = 0; ring < count; ++ring) {
      const double x = random.below(8), y = random.below(8);
      Path path;
      for (int v = 0, n = 3 + random.below(6); v < n; ++v) {
        const Point p{x + random.below(size), y + random.below(size)};
        if (path.empty() || (path.back() != p && path.front() != p)) path.push_back(p);
      }
      if (path.size() > 2) paths.push_back(path);
    }
    if (paths.empty()) continue;
    const Rings rings(paths);
    const std::optional<bool> meet = edges_meet(rings);
    if (!meet && !testing::usual_tuning) continue;
    ASSERT_TRUE(meet.has_value());
    ASSERT_EQ(*meet, meet_by_every_pair(rings)) << trial;
    ++(*meet ? meeting : apart);
  }
  EXPECT_GT(meeting, testing::usual_tuning ? 1000 : 100);
  EXPECT_GT(apart, testing::usual_tuning ? 1000 : 100);
}

TEST(RingTree, knowsHowDeepRingsLie) {
  generators::Random random(2);
  int deep = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<Path> paths;
    for (int ring = 0, count = 2 + random.below(12); ring < count; ++ring) {
      const double radius = std::exp2(-random.below(6));
      paths.push_back(round({random.in(0, 1), random.in(0, 1)}, radius, 3 + random.below(60), random));
      if (meet_by_every_pair(Rings(paths))) paths.pop_back();
    }
    const Rings rings(paths);
    RingTree tree;
    tree.build(rings.points, rings.ends);
    if (!tree.edges_meet() && !testing::usual_tuning) continue;
    ASSERT_EQ(tree.edges_meet(), false);
    const std::optional<Array<bool>> odd = tree.odd_depths();
    if (!odd && !testing::usual_tuning) continue;
    ASSERT_TRUE(odd.has_value());
    ASSERT_EQ(*odd, depths_by_every_edge(rings)) << trial;
    deep += static_cast<int>(std::count(odd->begin(), odd->end(), true));
  }
  EXPECT_GT(deep, testing::usual_tuning ? 1000 : 10);
}

TEST(RingTree, countsRingsThatStandLevelWithEachOther) {
  // The ray from each lower left corner runs along sides and through corners of the boxes to the left.
  std::vector<Path> paths{box(-1, -1, 40, 40)};
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      paths.push_back(box(4 * i, 4 * j, 4 * i + (j % 2 == 0 ? 3 : 2), 4 * j + (i % 2 == 0 ? 3 : 2)));
  const Rings rings(paths);
  RingTree tree;
  tree.build(rings.points, rings.ends);
  if (!tree.edges_meet() && !testing::usual_tuning) GTEST_SKIP() << "gives up sooner";
  EXPECT_EQ(tree.edges_meet(), false);
  Array<bool> expected(paths.size(), true);
  expected[0] = false;
  EXPECT_EQ(tree.odd_depths(), expected);
}

TEST(RingTree, givesUpWhereBoxesSayNothing) {
  // Spokes: the box of nearly every one meets that of nearly every other.
  Path spokes;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count, r = i % 2 == 0 ? 1 : 1000;
    spokes.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  EXPECT_EQ(edges_meet(Rings({spokes})), std::nullopt);
}

TEST(RingTree, takesFoldsForMeetings) {
  EXPECT_EQ(edges_meet(Rings({{{0, 0}, {4, 0}, {2, 0}, {2, 4}}})), true);
  EXPECT_EQ(edges_meet(Rings({{{4, 0}, {2, 0}, {2, 4}, {0, 0}}})), true);  // where the ring closes
  EXPECT_EQ(edges_meet(Rings({{{0, 0}, {4, 0}, {6, 0}, {2, 4}}})), false);
  EXPECT_EQ(edges_meet(Rings({{{0, 0}, {1, 0}, {2, 0}}})), true);  // flat
}

}  // namespace
}  // namespace oblast::internal::noding
