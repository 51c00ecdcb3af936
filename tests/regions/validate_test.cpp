// Bad arrays and bad coordinates are refused with their place.
#include "regions/validate.h"

#include <gtest/gtest.h>
#include <oblast/domain.h>

#include <cmath>
#include <limits>

#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

struct Refused {
  ErrorCode code;
  Place place;
};

Refused refusal(const RegionView& regions, std::size_t operand = 1) {
  try {
    validate(regions, operand);
  } catch (const Error& error) {
    return {error.code(), error.place()};
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

// Two polygons; the second has a hole, whose last vertex is vertex 9 of all.
RegionSet regions() { return verify::regions_of("0 0, 1 0, 0 1 | 5 0, 9 0, 9 9, 5 9; 6 1, 7 1, 6 2"); }

TEST(Validate, namesPolygonContourAndVertex) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  EXPECT_NO_THROW(validate(regions(), 0));
  for (const double bad :
       {nan, infinity, -infinity, 2 * domain_largest, domain_smallest / 2, -domain_smallest / 2, 5e-324}) {
    for (double Point::*coordinate : {&Point::x, &Point::y}) {
      RegionSet set = regions();
      set.points[9].*coordinate = bad;
      const Refused refused = refusal(set);
      EXPECT_EQ(refused.code, std::isfinite(bad) ? ErrorCode::out_of_domain : ErrorCode::not_finite);
      EXPECT_EQ(refused.place.operand, 1u);
      EXPECT_EQ(refused.place.polygon, 1u);
      EXPECT_EQ(refused.place.contour, 2u);
      EXPECT_EQ(refused.place.vertex, 2u);
      set.polygon_ends.clear();  // then every contour is a polygon
      EXPECT_EQ(refusal(set).place.polygon, 2u);
    }
  }
}

TEST(Validate, theFirstFaultIsNamed) {
  RegionSet set = regions();
  set.points[0].y = std::nan("");
  set.points[9].x = std::nan("");
  const Refused refused = refusal(set, 0);
  EXPECT_EQ(refused.place.operand, 0u);
  EXPECT_EQ(refused.place.polygon, 0u);
  EXPECT_EQ(refused.place.vertex, 0u);
}

TEST(Validate, theLimitsOfTheDomainAreInside) {
  RegionSet set = regions();
  for (const double good : {domain_largest, -domain_largest, domain_smallest, -domain_smallest, 0.0, -0.0}) {
    set.points[4].x = good;
    EXPECT_NO_THROW(validate(set, 0)) << good;
  }
  for (const double outside : {std::nextafter(domain_largest, INFINITY), std::nextafter(domain_smallest, 0.0)}) {
    for (const double sign : {1.0, -1.0}) {
      set.points[4].x = sign * outside;
      EXPECT_EQ(refusal(set).code, ErrorCode::out_of_domain) << set.points[4].x;
    }
  }
}

TEST(Validate, refusesOffsetsThatContradictTheArrays) {
  const auto code_of = [](std::vector<std::uint32_t> contour_ends, std::vector<std::uint32_t> polygon_ends) {
    RegionSet set = regions();
    set.contour_ends = std::move(contour_ends);
    set.polygon_ends = std::move(polygon_ends);
    return refusal(set).code;
  };
  EXPECT_EQ(code_of({3, 7, 11}, {1, 3}), ErrorCode::bad_offsets);  // past the points
  EXPECT_EQ(code_of({3, 7}, {1, 2}), ErrorCode::bad_offsets);      // points left over
  EXPECT_EQ(code_of({7, 3, 10}, {1, 3}), ErrorCode::bad_offsets);  // decreasing
  EXPECT_EQ(code_of({}, {}), ErrorCode::bad_offsets);              // points without contours
  EXPECT_EQ(code_of({3, 7, 10}, {1, 4}), ErrorCode::bad_offsets);  // past the contours
  EXPECT_EQ(code_of({3, 7, 10}, {1, 2}), ErrorCode::bad_offsets);  // contours left over
  EXPECT_EQ(code_of({3, 7, 10}, {3, 1, 3}), ErrorCode::bad_offsets);
  RegionSet set = regions();
  set.contour_ends = {0, 3, 3, 7, 10};  // empty contours are no fault
  set.polygon_ends = {0, 5, 5};
  EXPECT_NO_THROW(validate(set, 0));
  EXPECT_NO_THROW(validate(RegionView{}, 0));
}

}  // namespace
}  // namespace oblast::internal
