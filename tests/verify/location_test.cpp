// Sides of exact places by integers are those by rationals, for crossings of hostile edges and places between them.
#include "verify/location.h"

#include <gtest/gtest.h>

#include "generators/hostile.h"

namespace oblast::verify {
namespace {

int side_by_rationals(const Point& a, const Point& b, const RationalPoint& p) {
  const RationalPoint from(a), to(b);
  return ((to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x)).sign();
}

TEST(Location, SidesAreThoseByRationals) {
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    int on_line = 0;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const std::vector<Point> p = generator.make(seed, 16).a.points;
      std::vector<RationalPoint> places;
      for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        for (std::size_t j = 0; j < i && places.size() < 60; ++j) {
          if (const auto at = intersection_of_segments(p[i], p[i + 1], p[j], p[j + 1])) places.push_back(*at);
        }
      }
      for (std::size_t k = 0; k < places.size(); ++k) {
        const RationalPoint& next = places[(k + 1) % places.size()];
        const Location middle{Location(places[k]), Location(next)};
        for (std::size_t i = 0; i + 1 < p.size(); ++i) {
          const int side = side_by_rationals(p[i], p[i + 1], places[k]);
          on_line += side == 0 ? 1 : 0;
          ASSERT_EQ(side_of_line(p[i], p[i + 1], Location(places[k])), side) << generator.name << " seed " << seed;
          ASSERT_EQ(side_of_line(p[i], p[i + 1], middle), side_by_rationals(p[i], p[i + 1], middle.exact()))
              << generator.name << " seed " << seed;
          ASSERT_EQ(compare_y(middle, p[i].y), Rational(middle.exact().y - Rational(p[i].y)).sign());
        }
      }
    }
    EXPECT_GT(on_line, 0) << generator.name;
  }
}

}  // namespace
}  // namespace oblast::verify
