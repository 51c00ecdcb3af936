// check_closed and check_canonical on results written by hand: each fault is found, each valid form passes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verify/text_regions.h"
#include "verify/verify.h"

namespace oblast::verify {
namespace {

constexpr auto ogc = ContourConvention::ogc;
constexpr auto leonov_nikitin = ContourConvention::leonov_nikitin;

std::string fault_of(const RegionSet& regions, ContourConvention convention = ogc) {
  const auto fault = check_closed(regions, convention);
  return fault ? fault->what : "";
}

void expect_valid(const std::string& text, ContourConvention convention = ogc) {
  const auto fault = check_result(regions_of(text), convention);
  EXPECT_FALSE(fault) << text << ": " << fault->what;
}

void expect_fault(const std::string& text, const std::string& part, ContourConvention convention = ogc) {
  const auto fault = check_closed(regions_of(text), convention);
  ASSERT_TRUE(fault) << text;
  EXPECT_NE(fault->what.find(part), std::string::npos) << text << ": " << fault->what;
}

TEST(CheckClosed, acceptsWhatIsValid) {
  expect_valid("");
  expect_valid("0 0, 1 0, 0 1");
  expect_valid("0 0, 10 0, 10 10, 0 10; 2 2, 2 4, 4 4, 4 2; 6 6, 6 8, 8 8, 8 6");
  // A square in the hole of another, and a hole in that.
  expect_valid("0 0, 20 0, 20 20, 0 20; 2 2, 2 18, 18 18, 18 2 | 4 4, 16 4, 16 16, 4 16; 6 6, 6 14, 14 14, 14 6");
  // Two squares that touch at a corner are two polygons.
  expect_valid("0 0, 2 0, 2 2, 0 2 | 2 2, 4 2, 4 4, 2 4");
}

TEST(CheckClosed, acceptsPinchedHolesByConvention) {
  const std::string as_two_rings = "0 0, 8 0, 8 8, 0 8; 0 0, 1 3, 3 1";
  const std::string as_one_walk = "0 0, 1 3, 3 1, 0 0, 8 0, 8 8, 0 8";
  expect_valid(as_two_rings, ogc);
  expect_fault(as_two_rings, "hug", leonov_nikitin);
  expect_fault(as_one_walk, "twice", ogc);
  expect_valid("0 0, 1 3, 3 1, 0 0, 8 0, 8 8, 0 8", leonov_nikitin);
}

TEST(CheckClosed, findsFaultsOfForm) {
  expect_fault("0 0, 1 0", "fewer than three");
  expect_fault("0 0, 1 0, 1 0, 0 1", "repeated");
  expect_fault("0 0, 1 0, 0 1, 0 0", "repeated");
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    RegionSet regions = regions_of("0 0, 1 0, 0 1");
    regions.points[1].y = bad;
    EXPECT_EQ(fault_of(regions), "a coordinate is not finite");
  }
  for (const double bad : {0x1p301, 0x1p-301}) {
    RegionSet regions = regions_of("0 0, 1 0, 0 1");
    regions.points[1].y = bad;
    EXPECT_NE(fault_of(regions).find("outside the domain"), std::string::npos);
  }
  RegionSet regions = regions_of("0 0, 1 0, 0 1");
  regions.contour_ends = {2};
  EXPECT_NE(fault_of(regions), "");
  regions.contour_ends = {3, 3};
  EXPECT_NE(fault_of(regions), "");
}

TEST(CheckClosed, findsEdgesThatMeetBadly) {
  expect_fault("0 0, 4 0, 4 4, 0 4 | 3 3, 6 3, 6 6, 3 6", "crosses");
  expect_fault("0 0, 2 2, 2 0, 0 2", "crosses");
  expect_fault("0 0, 2 0, 2 2, 0 2 | 2 0, 4 0, 4 2, 2 2", "overlaps");  // a shared side
  expect_fault("0 0, 4 0, 2 4 | 2 0, 1 -2, 3 -2", "touches");           // a corner on a side
  expect_fault("0 0, 4 0, 4 4, 0 4 | 4 1, 6 1, 6 3, 4 3", "touches");
  expect_fault("0 0, 4 0, 2 0, 2 3", "");  // a spike
}

TEST(CheckClosed, findsOneUnitInTheLastPlace) {
  const double above = std::nextafter(1.0, 2.0);
  RegionSet regions = regions_of("0 0, 2 0, 2 2, 0 2 | 1 1, 2 2, 1 3");
  EXPECT_NE(fault_of(regions), "");
  // The corner (1, 1+) of the triangle clears the diagonal of the other one by an ulp, or does not.
  regions = regions_of("0 0, 3 0, 3 3 | 0 2, 1 1, 0 3");
  EXPECT_NE(fault_of(regions), "");
  regions.points[4].y = above;
  EXPECT_EQ(fault_of(regions), "");
  regions.points[4].y = std::nextafter(1.0, 0.0);
  EXPECT_NE(fault_of(regions), "");
}

TEST(CheckClosed, findsFaultsOfTopology) {
  expect_fault("0 0, 0 2, 2 2, 2 0", "left");                                      // clockwise
  expect_fault("0 0, 4 0, 4 4, 0 4 | 1 1, 2 1, 2 2, 1 2", "overlap");              // one inside the other
  expect_fault("0 0, 4 0, 4 4, 0 4; 1 1, 2 1, 2 2, 1 2", "wrong side");            // a hole the wrong way round
  expect_fault("0 0, 4 0, 4 4, 0 4; 5 1, 5 2, 6 2, 6 1", "left");                  // a hole outside
  expect_fault("0 0, 9 0, 9 9, 0 9; 1 1, 1 8, 8 8, 8 1; 3 3, 3 5, 5 5, 5 3", "");  // a hole in a hole
  expect_fault("0 0, 2 0, 2 2, 0 2; 4 0, 6 0, 6 2, 4 2", "not connected");         // two shells in one polygon
  // The shell of one polygon with the hole of another.
  expect_fault("0 0, 9 0, 9 9, 0 9 | 20 0, 29 0, 29 9, 20 9; 2 2, 2 4, 4 4, 4 2", "");
  // A hole in the island rather than in the polygon that it is filed under.
  expect_fault("0 0, 20 0, 20 20, 0 20; 2 2, 2 18, 18 18, 18 2; 6 6, 6 14, 14 14, 14 6 | 4 4, 16 4, 16 16, 4 16", "");
}

TEST(CheckClosed, findsInteriorsThatTouchingContoursCutApart) {
  // A hole that touches the shell at two vertices.
  expect_fault("0 0, 4 0, 8 0, 8 8, 4 8, 0 8; 4 0, 3 4, 4 8, 5 4", "not connected");
  // Two holes that touch each other at two vertices enclose a part of the interior.
  expect_fault("0 0, 20 0, 20 20, 0 20; 5 5, 3 10, 5 15, 4 10; 5 5, 6 10, 5 15, 8 10", "not connected");
  // Touching at one vertex each is fine: a chain of holes from the shell that does not come back.
  expect_valid("0 0, 20 0, 20 20, 0 20; 0 0, 1 3, 3 3; 3 3, 4 7, 7 7");
  // Two shells joined at a vertex are two polygons, not one.
  expect_fault("0 0, 2 0, 2 2, 4 2, 4 4, 2 4, 2 2, 0 2", "not connected");
  expect_fault("0 0, 2 0, 2 2, 4 2, 4 4, 2 4, 2 2, 0 2", "not connected", leonov_nikitin);
}

TEST(CheckClosed, findsContoursThatCrossAtAVertex) {
  expect_fault("0 0, 4 0, 4 2, 4 4, 2 4, 0 4 | 2 4, 4 2, 6 4, 4 6", "");
  expect_fault("0 0, 2 2, 4 0, 4 4, 2 2, 0 4", "");  // a bow tie through one vertex
}

TEST(CheckClosed, findsHolesThatTakeTheWrongTurn) {
  // Two holes that touch: one walk under leonov_nikitin, two rings under ogc.
  const std::string rings = "0 0, 20 0, 20 20, 0 20; 2 2, 5 8, 8 8; 8 8, 8 12, 12 8";
  expect_valid(rings);
  expect_fault(rings, "hug", leonov_nikitin);
  expect_valid("0 0, 20 0, 20 20, 0 20; 2 2, 5 8, 8 8, 8 12, 12 8, 8 8", leonov_nikitin);
}

TEST(CheckClosed, findsTheOuterContourInTheWrongPlace) {
  expect_fault("2 2, 2 4, 4 4, 4 2; 0 0, 10 0, 10 10, 0 10", "first contour");
}

TEST(CheckCanonical, findsWhatIsOutOfOrder) {
  const auto canonical = [](const std::string& text) { return !check_canonical(regions_of(text)); };
  EXPECT_TRUE(canonical("0 0, 2 0, 2 2"));
  EXPECT_FALSE(canonical("2 0, 2 2, 0 0"));
  EXPECT_TRUE(canonical("0 0, 1 0, 1 1 | 2 0, 3 0, 3 1"));
  EXPECT_FALSE(canonical("2 0, 3 0, 3 1 | 0 0, 1 0, 1 1"));
  // One common smallest vertex: the second vertices decide.
  EXPECT_TRUE(canonical("0 0, 2 -2, 2 -1 | 0 0, 2 1, 2 2"));
  EXPECT_FALSE(canonical("0 0, 2 1, 2 2 | 0 0, 2 -2, 2 -1"));
  EXPECT_TRUE(canonical("0 0, 9 0, 9 9, 0 9; 1 1, 1 2, 2 2; 3 1, 3 2, 4 2"));
  EXPECT_FALSE(canonical("0 0, 9 0, 9 9, 0 9; 3 1, 3 2, 4 2; 1 1, 1 2, 2 2"));
  // A walk through its smallest vertex twice.
  EXPECT_TRUE(canonical("0 0, 1 3, 3 1, 0 0, 8 0, 8 8, 0 8"));
  EXPECT_FALSE(canonical("0 0, 8 0, 8 8, 0 8, 0 0, 1 3, 3 1"));
  RegionSet regions = regions_of("0 0, 1 0, 1 1");
  regions.points[1].y = -0.0;
  EXPECT_TRUE(check_canonical(regions));
}

TEST(CheckClosed, namesThePlace) {
  const auto fault = check_closed(regions_of("0 0, 1 0, 0 1 | 5 5, 6 5, 6 5, 5 6"));
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->place.polygon, 1u);
  EXPECT_EQ(fault->place.contour, 1u);
  EXPECT_EQ(fault->place.vertex, 1u);
}

}  // namespace
}  // namespace oblast::verify
