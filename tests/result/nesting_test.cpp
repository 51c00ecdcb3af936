// Which ring belongs to which polygon, against containment by brute force.
#include "result/nesting.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "generators/random.h"
#include "support/graph_of.h"
#include "support/strands_of.h"
#include "verify/predicates.h"

namespace oblast::testing {
namespace {

std::vector<Point> ring_of(const Rings& rings, std::size_t r) {
  return {rings.points.begin() + rings.begin(r), rings.points.begin() + rings.ends[r]};
}

double area_of(const std::vector<Point>& ring) {
  RegionSet set;
  set.points = ring;
  set.contour_ends = {static_cast<std::uint32_t>(ring.size())};
  return signed_area(set);
}

/// p inside the ring, by an upward ray. REQUIRES: p is not on it.
bool holds(const std::vector<Point>& ring, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a.x <= p.x) == (b.x <= p.x)) continue;
    inside ^= verify::side_of_line(a, b, p) == (a.x < b.x ? -1 : 1);
  }
  return inside;
}

/// Every hole is in the polygon whose outer ring is the smallest one around it. REQUIRES: rings do not touch.
void expect_nested(const Linked& l) {
  const Nesting nesting = nest(l.graph, l.selection, l.contours, l.rings);
  std::vector<std::vector<Point>> rings;
  for (std::size_t r = 0; r < l.rings.size(); ++r) rings.push_back(ring_of(l.rings, r));
  std::vector<std::size_t> outer_of(nesting.polygon_count, rings.size());
  for (std::size_t r = 0; r < rings.size(); ++r) {
    ASSERT_EQ(nesting.outer[r], area_of(rings[r]) > 0);
    if (!nesting.outer[r]) continue;
    ASSERT_EQ(outer_of[nesting.polygon[r]], rings.size()) << "two outer rings in one polygon";
    outer_of[nesting.polygon[r]] = r;
  }
  for (const std::size_t r : outer_of) ASSERT_LT(r, rings.size()) << "a polygon without outer ring";
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (nesting.outer[r]) continue;
    std::size_t smallest = rings.size();
    for (std::size_t s = 0; s < rings.size(); ++s) {
      if (!nesting.outer[s] || !holds(rings[s], rings[r][0])) continue;
      if (smallest == rings.size() || area_of(rings[s]) < area_of(rings[smallest])) smallest = s;
    }
    ASSERT_LT(smallest, rings.size());
    ASSERT_EQ(outer_of[nesting.polygon[r]], smallest);
  }
}

TEST(Nesting, ofRingsInRings) {
  // Towers of squares, alternately filled and empty, several beside and inside each other.
  generators::Random random(1);
  RegionSet set;
  const auto add_tower = [&](double x, double y, double radius, int floors) {
    for (int i = 0; i < floors; ++i) {
      const double r = radius * (floors - i) / floors;
      for (const Point& p : box(x - r, y - r, x + r, y + r)) set.points.push_back(p);
      set.contour_ends.push_back(static_cast<std::uint32_t>(set.points.size()));
    }
  };
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) add_tower(10 * i, 10 * j, 4, 1 + random.below(6));
  add_tower(20, 20, 30, 2);  // around all of them, with a wide empty floor
  Options options;
  options.fill_a = FillRule::even_odd();
  const Linked l = linked_of(set, RegionSet{}, Operation::unite, options);
  EXPECT_GT(l.rings.size(), 50u);
  expect_nested(l);
}

TEST(Nesting, ofRandomHoles) {
  // A large square minus and plus small ones that may overlap: holes of any shape, with islands.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    generators::Random random(seed);
    RegionSet a, b;
    const auto add = [](RegionSet& set, const Path& ring) {
      set.points.insert(set.points.end(), ring.begin(), ring.end());
      set.contour_ends.push_back(static_cast<std::uint32_t>(set.points.size()));
    };
    add(a, box(-1, -1, 11, 11));
    for (int i = 0; i < 60; ++i) {
      const double x = random.in(0, 10), y = random.in(0, 10), w = random.in(0.1, 3), h = random.in(0.1, 0.3);
      add(b, random.one_in(2) ? box(x, y, x + w, y + h) : box(x, y, x + h, y + w));
    }
    Options options;
    options.fill_b = FillRule::even_odd();
    options.contours = ContourConvention::ogc;
    const Linked l = linked_of(a, b, Operation::difference, options);
    // With even_odd, rings touch at crossings. Compare only results in which no ring touches another.
    if (std::any_of(l.rings.flags.begin(), l.rings.flags.end(), [](auto f) { return (f & touch_vertex) != 0; })) {
      options.fill_b = FillRule::polygons();
      expect_nested(linked_of(a, b, Operation::difference, options));
    } else {
      expect_nested(l);
    }
    if (HasFatalFailure()) return;
  }
}

TEST(Nesting, ofRingsThatTouch) {
  const auto polygons_of = [](const Question& question) {
    const Linked l = linked_of(question);
    const Nesting nesting = nest(l.graph, l.selection, l.contours, l.rings);
    std::vector<std::size_t> rings(nesting.polygon_count, 0);
    for (const std::uint32_t p : nesting.polygon) ++rings[p];
    std::sort(rings.begin(), rings.end());
    return rings;
  };
  const std::string square = "0 0, 4 0, 4 4, 0 4";
  using Sizes = std::vector<std::size_t>;
  EXPECT_EQ(polygons_of({square, "2 0, 3 2, 1 2", Operation::difference}), (Sizes{2}));  // hole at the outer ring
  EXPECT_EQ(polygons_of({square, "1 1, 2 1, 2 2, 1 2 | 2 2, 3 2, 3 3, 2 3", Operation::difference}), (Sizes{3}));
  // Two holes with the same smallest vertex, in a separate walk: the chain below the lower one counts.
  EXPECT_EQ(polygons_of({square, "1 2, 3 2.5, 3 3 | 1 2, 3 1, 3 1.5", Operation::difference}), (Sizes{3}));
  EXPECT_EQ(polygons_of({square, "1 2, 3 1, 3 1.5 | 1 2, 3 2.5, 3 3", Operation::difference}), (Sizes{3}));
  EXPECT_EQ(polygons_of({square, "4 4, 6 4, 6 6, 4 6", Operation::unite}), (Sizes{1, 1}));
  // Four squares around an empty one, corner to corner: no hole.
  EXPECT_EQ(polygons_of({"1 0, 2 1, 1 2, 0 1 | 3 0, 4 1, 3 2, 2 1 | 1 2, 2 3, 1 4, 0 3 | 3 2, 4 3, 3 4, 2 3", ""}),
            (Sizes{1, 1, 1, 1}));
}

}  // namespace
}  // namespace oblast::testing
