// The signed area: signs, holes, and its error against exact rationals.
#include <gtest/gtest.h>
#include <oblast/region_set.h>

#include "generators/random.h"
#include "verify/rational.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using verify::regions_of;

verify::Rational exact_area(const RegionSet& set) {
  verify::Rational doubled = 0;
  for (std::size_t c = 0; c < set.contour_ends.size(); ++c) {
    const auto ring = set.view().contour(c);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      doubled += verify::Rational(p.x) * verify::Rational(q.y) - verify::Rational(q.x) * verify::Rational(p.y);
    }
  }
  return doubled / 2;
}

TEST(SignedArea, followsDirections) {
  EXPECT_EQ(signed_area(regions_of("0 0, 4 0, 4 3, 0 3")), 12);
  EXPECT_EQ(signed_area(regions_of("0 3, 4 3, 4 0, 0 0")), -12);
  EXPECT_EQ(signed_area(regions_of("0 0, 4 0, 4 3, 0 3; 1 1, 1 2, 2 2, 2 1")), 11);  // clockwise hole
  EXPECT_EQ(signed_area(regions_of("0 0, 2 2, 2 0, 0 2")), 0);                       // bow-tie
  EXPECT_EQ(signed_area(RegionSet{}), 0);
  EXPECT_EQ(signed_area(regions_of("1 1, 5 5")), 0);
}

TEST(SignedArea, isAccurateFarFromTheOrigin) {
  const double far = 0x1p40;
  RegionSet set = regions_of("0 0, 1 0, 1 1, 0 1");
  for (Point& p : set.points) p = {p.x + far, p.y - far};
  EXPECT_EQ(signed_area(set), 1);
}

TEST(SignedArea, largeTermsDoNotSwallowSmallOnes) {
  const RegionSet set = regions_of("0 0, 1e17 0, 1e17 1, 0 1 | 0 0, 1 0, 1 1, 0 1 | 0 0, 0 1, 1e17 1, 1e17 0");
  EXPECT_EQ(signed_area(set), 1);
}

TEST(SignedArea, isWithinAFewUlpsOfTheExactOne) {
  generators::Random random(1);
  for (int round = 0; round < 200; ++round) {
    RegionSet set;
    double terms = 0;
    for (int c = 0; c < 5; ++c) {
      const Point o{random.in(-180, 180), random.in(-90, 90)};
      for (int i = random.between(3, 12); i > 0; --i) set.points.push_back({o.x + random.unit(), o.y + random.unit()});
      set.contour_ends.push_back(static_cast<std::uint32_t>(set.points.size()));
      terms += 12;
    }
    const verify::Rational error = abs(verify::Rational(signed_area(set)) - exact_area(set));
    EXPECT_LE(static_cast<double>(error), terms * 0x1p-51);
  }
}

}  // namespace
}  // namespace oblast::internal
