// Places to test zones at: in the frame, and at borders.
#include "verify/zone_places.h"

#include <gtest/gtest.h>
#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

#include "verify/distance.h"
#include "verify/text_regions.h"

namespace oblast::verify {
namespace {

class ZonePlaces : public ::testing::Test {
 protected:
  const RegionSet frame_ = regions_of("8 8, 12 8, 12 12, 8 12"), row_ = regions_of("9 9, 11 9, 10 11");
  const std::vector<std::uint32_t> ends_{1};
  const std::vector<FeatureKey> keys_{{0, no_feature}};
  const ZoneObjects objects_{ShapeFeatures{}};
  const JudgedZones zones_{objects_, frame_, {row_, ends_}, keys_};

  /// How far a place is from the outline of the row.
  double to_border(const Point& p) const {
    double least = 1;
    for (std::size_t i = 0; i < 3; ++i)
      least = std::min(least, estimated_distance(p, {row_.points[i], row_.points[(i + 1) % 3]}).low);
    return least;
  }
};

TEST_F(ZonePlaces, HalfAreInTheFrameAndHalfAtBorders) {
  const std::vector<Point> places = zone_places(zones_, 600, 1);
  ASSERT_GE(places.size(), 1200u);
  EXPECT_LE(places.size(), 1206u);
  const Box box{frame_.points[0], frame_.points[2]};
  EXPECT_TRUE(std::all_of(places.begin(), places.begin() + 600, [&](const Point& p) { return box.meets({p, p}); }));
  constexpr double ulp = 0x1p-49;  // of coordinates from 8 to 16
  EXPECT_TRUE(std::all_of(places.begin() + 600, places.end(), [&](const Point& p) { return to_border(p) < 8 * ulp; }));
  EXPECT_GT(to_border(places[0]), 8 * ulp);
}

TEST(ZonePlacesAtZero, StayInTheDomain) {
  const RegionSet row = regions_of("0 0, 1 0, 0 1");
  const std::vector<FeatureKey> keys{{0, no_feature}};
  const ZoneObjects objects{ShapeFeatures{}};
  bool is_moved = false;
  for (const Point& p : zone_places({objects, row, {row, {}}, keys}, 600, 1)) {
    EXPECT_TRUE(in_domain(p.x) && in_domain(p.y));
    is_moved |= p.x != 0 && std::abs(p.x) < 0x1p-290;
  }
  EXPECT_TRUE(is_moved);
}

TEST_F(ZonePlaces, EveryVertexIsOne) {
  const std::vector<Point> places = zone_places(zones_, 18, 1);
  for (const Point& p : row_.points) EXPECT_NE(std::find(places.begin() + 18, places.end(), p), places.end());
}

TEST_F(ZonePlaces, ASeedDrawsTheSameAgain) {
  EXPECT_EQ(zone_places(zones_, 100, 7), zone_places(zones_, 100, 7));
  EXPECT_NE(zone_places(zones_, 100, 7), zone_places(zones_, 100, 8));
}

TEST_F(ZonePlaces, WithoutRowsAllAreInTheFrame) {
  EXPECT_EQ(zone_places({objects_, frame_, {}, {}}, 10, 1).size(), 10u);
  EXPECT_TRUE(zone_places({objects_, {}, {}, {}}, 10, 1).empty());
}

}  // namespace
}  // namespace oblast::verify
