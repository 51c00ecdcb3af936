// Layers: known cases, and first fit against its definition by overlays of pairs.
#include <gtest/gtest.h>
#include <oblast/layers.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <cmath>

#include "generators/random.h"
#include "generators/soup.h"

namespace oblast::internal {
namespace {

using namespace generators;

using Indices = std::vector<std::uint32_t>;

RegionSet of(std::initializer_list<Ring> rings) {
  RegionSet set;
  for (const Ring& ring : rings) add_polygon(set, ring);
  return set;
}

/// Layers of two contours: 1 or 2, the same for every order, start and direction.
std::uint32_t count_of(Ring p, Ring q) {
  const std::uint32_t count = layers(of({p, q})).count;
  for (int turn = 0; turn < 4; ++turn) {
    EXPECT_EQ(layers(of({p, q})).count, count);
    EXPECT_EQ(layers(of({q, reversed(p)})).count, count);
    std::rotate(p.begin(), p.begin() + 1, p.end());
    std::rotate(q.begin(), q.begin() + 2, q.end());
  }
  return count;
}

TEST(Layers, ofNothing) {
  EXPECT_EQ(layers(RegionSet{}).count, 0u);
  EXPECT_TRUE(layers(RegionSet{}).layer.empty());
}

TEST(Layers, disjointContoursShareOne) {
  const Layers found = layers(of({rectangle(0, 0, 1, 1), rectangle(2, 0, 3, 1), rectangle(0, 2, 1, 3)}));
  EXPECT_EQ(found.count, 1u);
  EXPECT_EQ(found.layer, (Indices{0, 0, 0}));
}

TEST(Layers, firstFitInTheOrderOfTheInput) {
  // A chain of overlaps: each with the one before.
  const Layers found = layers(of({rectangle(0, 0, 2, 1), rectangle(1, 0, 4, 1), rectangle(3, 0, 6, 1),
                                  rectangle(1.5, 0, 3.5, 1), rectangle(9, 0, 10, 1)}));
  EXPECT_EQ(found.layer, (Indices{0, 1, 0, 2, 0}));
  EXPECT_EQ(found.count, 3u);
}

TEST(Layers, copiesHaveOneEach) {
  RegionSet copies;
  for (int i = 0; i < 300; ++i) add_polygon(copies, rectangle(0, 0, 1, 1));
  const Layers found = layers(copies);
  EXPECT_EQ(found.count, 300u);
  for (std::uint32_t i = 0; i < 300; ++i) EXPECT_EQ(found.layer[i], i);
}

TEST(Layers, nestedContoursOverlap) {
  EXPECT_EQ(count_of(rectangle(0, 0, 9, 9), rectangle(3, 3, 4, 4)), 2u);
  EXPECT_EQ(count_of(rectangle(0, 0, 9, 9), rectangle(0, 0, 4, 4)), 2u);     // along two sides
  EXPECT_EQ(count_of(rectangle(0, 0, 9, 9), {{0, 0}, {4, 1}, {1, 4}}), 2u);  // at a corner
  EXPECT_EQ(count_of(rectangle(0, 0, 9, 9), {{0, 4}, {4, 3}, {4, 5}}), 2u);  // at a side
}

TEST(Layers, neighboursDoNotOverlap) {
  const Ring square = rectangle(0, 0, 4, 4);
  EXPECT_EQ(count_of(square, rectangle(4, 0, 8, 4)), 1u);                           // a whole side
  EXPECT_EQ(count_of(square, rectangle(4, 1, 8, 6)), 1u);                           // part of a side
  EXPECT_EQ(count_of(square, rectangle(4, 4, 8, 8)), 1u);                           // a corner
  EXPECT_EQ(count_of(square, {{4, 2}, {6, 1}, {6, 3}}), 1u);                        // a corner at a side
  EXPECT_EQ(count_of({{0, 0}, {4, 0}, {0, 4}}, {{4, 0}, {4, 4}, {0, 4}}), 1u);      // boxes are the same
  EXPECT_EQ(count_of({{0, 0}, {9, 0}, {0, 9}}, {{9, 9}, {5, 5.5}, {5.5, 5}}), 1u);  // boxes overlap
}

TEST(Layers, sectorsAtReflexVertices) {
  const Ring hook = {{0, 0}, {6, 0}, {6, 6}, {3, 6}, {3, 3}, {0, 3}};  // a square less its upper left quarter
  EXPECT_EQ(count_of(hook, rectangle(0, 3, 3, 6)), 1u);
  EXPECT_EQ(count_of(hook, {{3, 3}, {2, 5}, {1, 4}}), 1u);
  EXPECT_EQ(count_of(hook, {{3, 3}, {4, 3}, {4, 4}}), 2u);
  EXPECT_EQ(count_of(hook, {{3, 3}, {2, 5}, {2, 2}}), 2u);
  EXPECT_EQ(count_of(hook, {{3, 3}, {3, 5}, {1, 3}}), 1u);
  EXPECT_EQ(count_of(hook, reversed(hook)), 2u);
}

TEST(Layers, boxesAreCoarser) {
  const RegionSet halves = of({{{0, 0}, {4, 0}, {0, 4}}, {{4, 0}, {4, 4}, {0, 4}}});
  EXPECT_EQ(layers(halves, LayerRule::interiors).count, 1u);
  EXPECT_EQ(layers(halves, LayerRule::boxes).count, 2u);
  EXPECT_EQ(layers(of({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)}), LayerRule::boxes).count, 1u);
}

TEST(Layers, contoursWithoutInteriorAreInTheFirst) {
  const Layers found = layers(of({rectangle(0, 0, 4, 4), {{1, 1}}, {{1, 1}, {2, 2}}, {{1, 1}, {1, 1}, {3, 3}}}));
  EXPECT_EQ(found.layer, (Indices{0, 0, 0, 0}));
}

TEST(Layers, contoursThatMeetThemselvesAreKeptApart) {
  const Ring bow_tie = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  EXPECT_EQ(count_of(bow_tie, {{1, 0}, {3, 0}, {2, 1}}), 2u);
  EXPECT_EQ(count_of(bow_tie, rectangle(4, 0, 5, 4)), 1u);
}

TEST(Layers, badInputIsRefused) {
  RegionSet bad = of({rectangle(0, 0, 1, 1)});
  bad.points[2].x = NAN;
  EXPECT_THROW(layers(bad), Error);
}

/// A star-shaped contour around a point, on a lattice so that touching is common.
Ring star(const Point& centre, int corners, double radius, Random& random) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners, r = radius * (0.3 + 0.1 * random.between(0, 7));
    const Point p{std::round(centre.x + r * std::cos(angle)), std::round(centre.y + r * std::sin(angle))};
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  }
  return ring;
}

/// First fit by its definition: contours overlap when their intersection is not empty. Only for simple
/// contours on a small lattice: there no intersection is so thin that rounding loses it.
Layers by_overlays(const RegionSet& set) {
  const RegionView view = set;
  Layers result;
  for (std::size_t i = 0; i < view.contour_count(); ++i) {
    std::vector<bool> taken(result.count + 1, false);
    for (std::size_t j = 0; j < i; ++j) {
      RegionSet p, q;
      add_polygon(p, Ring(view.contour(i).begin(), view.contour(i).end()));
      add_polygon(q, Ring(view.contour(j).begin(), view.contour(j).end()));
      if (!overlay(p, q, Operation::intersection).empty()) taken[result.layer[j]] = true;
    }
    const auto layer = static_cast<std::uint32_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    result.layer.push_back(layer);
    result.count = std::max(result.count, layer + 1);
  }
  return result;
}

bool is_simple(const Ring& ring) {
  const RegionSet alone = of({ring});
  const RegionSet united = unite(alone);
  return united.contour_ends.size() == 1 && united.points.size() == ring.size();
}

TEST(Layers, areFirstFitOnRandomContours) {
  std::uint32_t most = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    RegionSet set;
    while (set.polygon_ends.size() < 40) {
      const Point centre{static_cast<double>(random.between(0, 60)), static_cast<double>(random.between(0, 60))};
      Ring ring = star(centre, random.between(3, 30), random.between(3, 25), random);
      if (ring.size() < 3 || !is_simple(ring)) continue;
      add_polygon(set, random.between(0, 1) ? ring : reversed(ring));
    }
    const Layers found = layers(set);
    ASSERT_EQ(found, by_overlays(set)) << "seed " << seed;
    most = std::max(most, found.count);
    EXPECT_LE(found.count, layers(set, LayerRule::boxes).count);
  }
  EXPECT_GT(most, 4u);
}

}  // namespace
}  // namespace oblast::internal
