// Tests of the generators: they are repeatable, stay in the domain, and do what their names say.
#include <gtest/gtest.h>
#include <oblast/domain.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <set>

#include "generators/crowd.h"
#include "generators/far.h"
#include "generators/hostile.h"
#include "generators/shrink.h"
#include "generators/soup.h"
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

TEST(FarSquares, meetNoPolygon) {
  std::size_t squares = 0;
  for (const HostileGenerator& generator : hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const Operands operands = generator.make(seed, 20);
      const FarSquares far = far_squares(operands, seed);
      std::vector<Box> mine, theirs;
      add_boxes_of_polygons(mine, operands.a);
      add_boxes_of_polygons(mine, operands.b);
      add_boxes_of_polygons(theirs, far.a);
      add_boxes_of_polygons(theirs, far.b);
      squares += theirs.size();
      for (const Box& box : theirs) {
        for (const Box& own : mine) ASSERT_FALSE(box.meets(own)) << generator.name << " " << seed;
      }
    }
  }
  EXPECT_GT(squares, 40u * hostile_generators().size());
}

TEST(Crowd, membersKeepApartAndInTheDomain) {
  std::vector<CrowdMember> members;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const HostileGenerator& generator : hostile_generators())
      members.push_back({&generator, seed, generator.make(seed, 20)});
  }
  for (const Places places : {Places::row, Places::scale}) {
    std::vector<CrowdMember> moved = members;
    put_in_places(moved, places);
    for (std::size_t m = 0; m < moved.size(); ++m) {
      const Operands& operands = moved[m].operands;
      for (const Point& p : operands.a.points) ASSERT_TRUE(in_domain(p.x) && in_domain(p.y));
      for (std::size_t n = 0; n < m; ++n)
        ASSERT_FALSE(box_of(operands).meets(box_of(moved[n].operands))) << m << " " << n;
    }
  }
}

// If a case is clear of the axes, dividing by its scale restores it bit for bit.
TEST(Crowd, scalingKeepsBits) {
  const HostileGenerator& generator =
      *std::find_if(hostile_generators().begin(), hostile_generators().end(),
                    [](const auto& g) { return std::string(g.name) == "far_from_origin"; });
  std::vector<CrowdMember> members{{&generator, 5, generator.make(5, 20)}};
  const Operands before = members[0].operands;
  put_in_places(members, Places::scale);
  const double factor = members[0].operands.a.points[0].x / before.a.points[0].x;
  EXPECT_NE(factor, 1);
  for (std::size_t i = 0; i < before.a.points.size(); ++i)
    EXPECT_EQ(members[0].operands.a.points[i].x, before.a.points[i].x * factor);
}

TEST(IsLocal, seesWhetherPartsAreTheWhole) {
  const auto square = [](double x) { return rectangle(x, 0, x + 1, 1); };
  Operands operands;
  for (const double x : {4, 0, 2}) add_polygon(operands.a, square(x));
  EXPECT_TRUE(is_local(operands, Operation::unite, {}));
  const RegionSet whole = unite(operands.a);
  std::vector<RegionSet> parts(3);
  for (std::size_t i = 0; i < 3; ++i) append_polygon(parts[i], operands.a, i);
  EXPECT_EQ(put_in_order(parts), whole);
  parts.pop_back();
  EXPECT_NE(put_in_order(parts), whole);
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
  EXPECT_THROW(soup_from_wkt("POLYGON ((0 0, 1 0, 0 1, 0 0)) and more"), std::invalid_argument);
}

}  // namespace
}  // namespace oblast::generators
