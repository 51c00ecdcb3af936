// The generators themselves: they repeat, stay in the domain and do what their names say.
#include <gtest/gtest.h>
#include <oblast/domain.h>

#include <algorithm>
#include <set>

#include "generators/hostile.h"
#include "generators/shrink.h"
#include "generators/trial.h"
#include "generators/wkt.h"

namespace oblast::generators {
namespace {

TEST(HostileGenerators, areFunctionsOfSeedAndSize) {
  for (const HostileGenerator& generator : hostile_generators()) {
    const Operands one = generator.make(7, 40), same = generator.make(7, 40), other = generator.make(8, 40);
    EXPECT_EQ(one.a, same.a) << generator.name;
    EXPECT_EQ(one.b, same.b) << generator.name;
    EXPECT_FALSE(one.a == other.a && one.b == other.b) << generator.name;
  }
}

TEST(HostileGenerators, stayInTheDomainAndNearTheSize) {
  for (const HostileGenerator& generator : hostile_generators()) {
    std::size_t vertices = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const Operands operands = generator.make(seed, 40);
      for (const RegionSet* soup : {&operands.a, &operands.b}) {
        vertices += soup->points.size();
        for (const Point& p : soup->points) ASSERT_TRUE(in_domain(p.x) && in_domain(p.y)) << generator.name;
        if (!soup->contour_ends.empty()) {
          ASSERT_EQ(soup->contour_ends.back(), soup->points.size());
          ASSERT_EQ(soup->polygon_ends.back(), soup->contour_ends.size());
        }
      }
    }
    EXPECT_GT(vertices / 200, 10u) << generator.name;
    EXPECT_LT(vertices / 200, 160u) << generator.name;
  }
}

TEST(Shuffled, isTheSameOperandInAnotherOrder) {
  const Operands operands = integer_grid(3, 60);
  const auto sorted_points = [](const RegionSet& regions) {
    std::multiset<std::pair<double, double>> points;
    for (const Point& p : regions.points) points.emplace(p.x, p.y);
    return points;
  };
  const RegionSet other = shuffled(operands.a, FillRule::positive(), 1);
  EXPECT_NE(other, operands.a);
  EXPECT_EQ(sorted_points(other), sorted_points(operands.a));
  EXPECT_EQ(other.polygon_ends.size(), operands.a.polygon_ends.size());
  EXPECT_DOUBLE_EQ(signed_area(other), signed_area(operands.a)) << "`positive` sees directions: none may be reversed";
}

TEST(Shrink, leavesOnlyWhatFails) {
  const Operands operands = integer_grid(3, 60);
  // "Fails" while the operands have a vertex in common.
  const auto fails = [](const Operands& o) {
    return std::find_first_of(o.a.points.begin(), o.a.points.end(), o.b.points.begin(), o.b.points.end()) !=
           o.a.points.end();
  };
  ASSERT_TRUE(fails(operands));
  const Operands small = shrink(operands, fails);
  EXPECT_TRUE(fails(small));
  EXPECT_EQ(small.a.points.size(), 3u);
  EXPECT_EQ(small.b.points.size(), 3u);
}

TEST(SoupToWkt, writesPolygonsAndHoles) {
  RegionSet soup;
  soup.points = {{0, 0}, {1, 0}, {0, 0.1}, {2, 2}, {3, 2}, {2, 3}};
  soup.contour_ends = {3, 6};
  soup.polygon_ends = {1, 2};
  EXPECT_EQ(soup_to_wkt(soup), "MULTIPOLYGON (((0 0, 1 0, 0 0.1, 0 0)), ((2 2, 3 2, 2 3, 2 2)))");
  soup.polygon_ends = {2};
  EXPECT_EQ(soup_to_wkt(soup), "MULTIPOLYGON (((0 0, 1 0, 0 0.1, 0 0), (2 2, 3 2, 2 3, 2 2)))");
  EXPECT_EQ(soup_to_wkt(RegionSet{}), "MULTIPOLYGON EMPTY");
}

TEST(SoupFromWkt, readsWhatWasWritten) {
  for (const HostileGenerator& generator : hostile_generators()) {
    const RegionSet soup = generator.make(11, 40).b;
    EXPECT_EQ(soup_from_wkt(soup_to_wkt(soup)), soup) << generator.name;
  }
  EXPECT_EQ(soup_from_wkt("POLYGON((0 0,1 0,0 1,0 0))").points.size(), 3u);
  EXPECT_THROW(soup_from_wkt("POINT (1 2)"), std::invalid_argument);
  EXPECT_THROW(soup_from_wkt("POLYGON ((1 2, 3 x"), std::invalid_argument);
}

}  // namespace
}  // namespace oblast::generators
