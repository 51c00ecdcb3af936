#include "verify/buffer_reference.h"

#include <gtest/gtest.h>
#include <oblast/buffer.h>

namespace oblast::verify {
namespace {

/// A square with a hole, and a line.
struct Case {
  RegionSet regions{{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {3, 3}, {3, 7}, {7, 7}, {7, 3}}, {4, 8}, {2}};
  std::vector<Point> line{{20, 0}, {30, 0}, {25, 8}};

  ZoneOf shapes() const { return {regions, {{line[0], line[1]}, {line[1], line[2]}}}; }
  RegionSet zone(double distance) const {
    const std::uint32_t end = 3;
    return buffer({regions, {line, {&end, 1}}, {}}, distance);
  }
};

ZoneBounds bounds_of(double distance) { return {0.99 * distance, 1.01 * distance}; }

/// Without the contours that `drop` names, counted by polygon.
RegionSet without_contour(const RegionSet& regions, std::size_t drop) {
  RegionSet left;
  std::size_t c = 0;
  for (const PolygonView polygon : regions.polygons()) {
    const std::size_t before = left.contour_ends.size();
    for (const std::span<const Point> contour : polygon.contours()) {
      if (c++ == drop) continue;
      left.points.insert(left.points.end(), contour.begin(), contour.end());
      left.contour_ends.push_back(static_cast<std::uint32_t>(left.points.size()));
    }
    if (left.contour_ends.size() > before)
      left.polygon_ends.push_back(static_cast<std::uint32_t>(left.contour_ends.size()));
  }
  return left;
}

TEST(BufferReference, RightZonesPass) {
  const Case c;
  EXPECT_FALSE(check_references(c.zone(1), c.shapes(), bounds_of(1)));
  EXPECT_FALSE(check_references(c.zone(5), c.shapes(), bounds_of(5)));
  EXPECT_FALSE(check_inner_references(c.zone(-1), {c.regions, {}}, bounds_of(1)));
}

TEST(BufferReference, PointsAreShapes) {
  const Point p{3, 4};
  const ZoneOf shapes{{}, {{p, p}}};
  const RegionSet zone = buffer({{}, {}, {&p, 1}}, 1);
  EXPECT_FALSE(check_references(zone, shapes, bounds_of(1)));
  EXPECT_TRUE(check_references({}, shapes, bounds_of(1)));
  EXPECT_TRUE(check_references(buffer({{}, {}, {&p, 1}}, 1.2), shapes, bounds_of(1)));
}

TEST(BufferReference, EveryContourIsMissed) {
  const Case c;
  const RegionSet zone = c.zone(1);
  ASSERT_EQ(zone.contour_ends.size(), 3);  // the square, its hole, the line
  for (std::size_t drop = 0; drop < 3; ++drop)
    EXPECT_TRUE(check_references(without_contour(zone, drop), c.shapes(), bounds_of(1))) << drop;
  const RegionSet inner = c.zone(-1);
  ASSERT_EQ(inner.contour_ends.size(), 2);
  for (std::size_t drop = 0; drop < 2; ++drop)
    EXPECT_TRUE(check_inner_references(without_contour(inner, drop), {c.regions, {}}, bounds_of(1))) << drop;
}

TEST(BufferReference, AnotherDistanceIsSeen) {
  const Case c;
  // The octagons leave some room: up to 8 % of the distance on both sides.
  for (const double distance : {0.85, 1.15})
    EXPECT_TRUE(check_references(c.zone(distance), c.shapes(), bounds_of(1))) << distance;
}

}  // namespace
}  // namespace oblast::verify
