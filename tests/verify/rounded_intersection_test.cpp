// Rounded intersections by integers are those by rationals, for all pairs of edges of hostile cases.
#include "verify/rounded_intersection.h"

#include <gtest/gtest.h>

#include "generators/hostile.h"
#include "verify/rational.h"

namespace oblast::verify {
namespace {

std::optional<Point> by_rationals(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto meeting = intersection_of_segments(a, b, c, d);
  if (!meeting) return std::nullopt;
  return Point{round_into_domain(meeting->x), round_into_domain(meeting->y)};
}

TEST(RoundedIntersection, IsThatByRationals) {
  for (const generators::HostileGenerator& generator : generators::hostile_generators()) {
    int meetings = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const generators::Operands operands = generator.make(seed, 24);
      const auto& p = operands.a.points;
      for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const auto expected = by_rationals(p[i], p[i + 1], p[j], p[j + 1]);
          ASSERT_EQ(rounded_intersection(p[i], p[i + 1], p[j], p[j + 1]), expected)
              << generator.name << " seed " << seed << ", edges " << i << " and " << j;
          meetings += expected ? 1 : 0;
        }
      }
    }
    EXPECT_GT(meetings, 0) << generator.name;
  }
}

TEST(RoundedIntersection, OfCollinearSegments) {
  EXPECT_EQ(rounded_intersection({0, 0}, {3, 1}, {6, 2}, {3, 1}), (Point{3, 1}));
  EXPECT_EQ(rounded_intersection({6, 2}, {3, 1}, {0, 0}, {3, 1}), (Point{3, 1}));
  EXPECT_EQ(rounded_intersection({0, 0}, {3, 1}, {9, 3}, {6, 2}), std::nullopt);
  EXPECT_EQ(rounded_intersection({0, 0}, {6, 2}, {3, 1}, {9, 3}), std::nullopt);  // they overlap
  EXPECT_EQ(rounded_intersection({0, 0}, {3, 1}, {3, 2}, {6, 3}), std::nullopt);  // they are parallel
}

TEST(RoundedIntersection, AtTheLimitsOfTheDomain) {
  constexpr double smallest = 0x1p-300, largest = 0x1p300;
  EXPECT_EQ(rounded_intersection({-largest, -largest}, {largest, largest}, {-largest, largest}, {largest, -largest}),
            (Point{0, 0}));
  // They meet at a third of the smallest magnitude, which becomes 0, and at two thirds, which becomes the smallest.
  for (const double at : {1.0, 2.0}) {
    const auto met = rounded_intersection({0, 0}, {smallest, 0}, {0, -at}, {smallest, 3 - at});
    EXPECT_EQ(met, (Point{at == 1 ? 0.0 : smallest, 0.0}));
  }
}

}  // namespace
}  // namespace oblast::verify
