// Canonical order, whichever way the rings come; parts joined are parts assembled together.
#include "result/assemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "generators/random.h"
#include "verify/text_regions.h"
#include "verify/verify.h"

namespace oblast::internal {
namespace {

using generators::Random;
using verify::regions_of;

/// The contours of a canonical set as rings in another order, each begun elsewhere, with their nesting.
struct Shuffled {
  Rings rings;
  Nesting nesting;
};

Shuffled shuffled(const RegionSet& set, Random& random) {
  const RegionView view = set;
  struct Ring {
    std::size_t contour;
    std::uint32_t polygon;
    bool outer;
  };
  std::vector<Ring> order;
  std::vector<std::uint32_t> number(view.polygon_count());
  std::iota(number.begin(), number.end(), 0U);
  const auto shuffle = [&](auto& items) {
    for (std::size_t i = items.size(); i > 1; --i)
      std::swap(items[i - 1], items[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  };
  shuffle(number);
  for (std::size_t p = 0; p < view.polygon_count(); ++p)
    for (std::uint32_t c = view.polygon_begin(p); c < view.polygon_end(p); ++c)
      order.push_back({c, number[p], c == view.polygon_begin(p)});
  shuffle(order);
  Shuffled s;
  s.nesting.polygon_count = static_cast<std::uint32_t>(view.polygon_count());
  for (const Ring& ring : order) {
    const auto contour = view.contour(ring.contour);
    const int start = random.below(static_cast<int>(contour.size()));
    for (std::size_t i = 0; i < contour.size(); ++i)
      s.rings.points.push_back(contour[(i + static_cast<std::size_t>(start)) % contour.size()]);
    s.rings.ends.push_back(static_cast<std::uint32_t>(s.rings.points.size()));
    s.nesting.polygon.push_back(ring.polygon);
    s.nesting.outer.push_back(ring.outer);
  }
  s.rings.flags.resize(s.rings.points.size(), 0);
  return s;
}

TEST(Assemble, putsContoursInCanonicalOrder) {
  // Two polygons that begin at the same vertex, holes, an island, and a contour that passes its smallest vertex twice.
  const RegionSet canonical = regions_of(
      "0 0, 4 -4, 4 -3 | 0 0, 4 0, 4 1 | 1 2, 9 2, 9 9, 1 9; 2 3, 2 4, 3 4, 3 3; 2 5, 2 6, 3 6, 3 5; 5 3, 5 8, 8 8, 8 3"
      "| 6 4, 7 4, 7 5, 6 5 | 20 0, 21 -2, 22 -2, 20 0, 21 2, 20.5 2");
  ASSERT_EQ(verify::check_canonical(canonical), std::nullopt);
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const Shuffled s = shuffled(canonical, random);
    ASSERT_EQ(assemble(s.rings, s.nesting), canonical);
  }
}

TEST(Assemble, ofNothingIsNothing) { EXPECT_TRUE(assemble({}, {}).empty()); }

TEST(Join, isAssemblingTogether) {
  // Polygons at random places, dealt to parts.
  Random random(2);
  for (int round = 0; round < 50; ++round) {
    constexpr int parts_count = 7;
    Array<RegionSet> parts(parts_count);
    RegionSet all;
    for (int i = 0; i < 60; ++i) {
      RegionSet polygon = regions_of("0 0, 4 0, 4 4, 0 4; 1 1, 1 2, 2 2; 2 2, 2 3, 3 3");
      const Point at{5.0 * random.below(5), 5.0 * i};
      const std::size_t rings = 1 + static_cast<std::size_t>(random.below(3));
      RegionSet& part = parts[static_cast<std::size_t>(random.below(parts_count))];
      for (RegionSet* set : {&all, &part}) {
        for (std::size_t c = 0; c < rings; ++c) {
          for (const Point& p : polygon.view().contour(c)) set->points.push_back({p.x + at.x, p.y + at.y});
          set->contour_ends.push_back(static_cast<std::uint32_t>(set->points.size()));
        }
        set->polygon_ends.push_back(static_cast<std::uint32_t>(set->contour_ends.size()));
      }
    }
    for (RegionSet& part : parts) {
      const Shuffled s = shuffled(part, random);
      part = assemble(s.rings, s.nesting);
    }
    const Shuffled s = shuffled(all, random);
    ASSERT_EQ(join(parts), assemble(s.rings, s.nesting));
  }
}

TEST(Join, keepsPolygonsOfOnePartThatBeginAtTheSameVertexInTheirOrder) {
  const RegionSet touching = regions_of("5 0, 9 -4, 9 -3 | 5 0, 9 0, 9 1"), before = regions_of("4 9, 5 9, 5 10"),
                  after = regions_of("6 9, 7 9, 7 10");
  const RegionSet joined = join({after, touching, before});
  EXPECT_EQ(joined, regions_of("4 9, 5 9, 5 10 | 5 0, 9 -4, 9 -3 | 5 0, 9 0, 9 1 | 6 9, 7 9, 7 10"));
}

TEST(Join, ofEmptyParts) {
  const RegionSet square = regions_of("0 0, 1 0, 1 1");
  EXPECT_TRUE(join({}).empty());
  EXPECT_TRUE(join({RegionSet{}, RegionSet{}}).empty());
  EXPECT_EQ(join({RegionSet{}, square, RegionSet{}}), square);
}

}  // namespace
}  // namespace oblast::internal
