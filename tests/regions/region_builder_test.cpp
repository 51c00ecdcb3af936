// Builds region sets from points of any type, and tests refused input.
#include <gtest/gtest.h>
#include <oblast/region_builder.h>

#include <array>
#include <complex>
#include <deque>
#include <list>
#include <tuple>
#include <vector>

#include "verify/text_regions.h"

namespace oblast {
namespace {

using verify::regions_of;

struct WithMembers {
  float x, y, z;
};
class WithMethods {
 public:
  WithMethods(int x, int y) : x_(x), y_(y) {}
  int x() const { return x_; }
  int y() const { return y_; }

 private:
  int x_, y_;
};

static_assert(AnyPoint<Point> && AnyPoint<WithMembers> && AnyPoint<WithMethods>);
static_assert(AnyPoint<std::array<float, 3>> && AnyPoint<std::tuple<int, double>> && AnyPoint<double[2]>);
static_assert(!AnyPoint<double> && !AnyPoint<std::array<int, 1>>);
static_assert(!AnyContour<Point> && AnyContour<std::span<const Point>>);

TEST(RegionBuilder, takesPointsOfManyTypes) {
  const RegionSet triangle = regions_of("0 0, 4 0, 0 3");
  const auto built = [](const auto& contour) {
    RegionBuilder builder;
    builder.add_contour(contour);
    return builder.take();
  };
  EXPECT_EQ(built(std::vector<Point>{{0, 0}, {4, 0}, {0, 3}}), triangle);
  EXPECT_EQ(built(std::list<WithMembers>{{0, 0, 9}, {4, 0, 9}, {0, 3, 9}}), triangle);
  EXPECT_EQ(built(std::deque<WithMethods>{{0, 0}, {4, 0}, {0, 3}}), triangle);
  EXPECT_EQ(built(std::vector<std::array<double, 2>>{{0, 0}, {4, 0}, {0, 3}}), triangle);
  EXPECT_EQ(built(std::array<std::pair<float, int>, 3>{{{0.f, 0}, {4.f, 0}, {0.f, 3}}}), triangle);
  EXPECT_EQ(built(std::vector<std::tuple<unsigned char, long, char>>{{0, 0, 'a'}, {4, 0, 'b'}, {0, 3, 'c'}}), triangle);
  const double plain[3][2] = {{0, 0}, {4, 0}, {0, 3}};
  EXPECT_EQ(built(plain), triangle);
  EXPECT_EQ(built(triangle.view().contour(0)), triangle);
}

TEST(RegionBuilder, groupsContoursIntoPolygons) {
  const std::vector<Point> shell = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const std::vector<std::array<int, 2>> hole = {{1, 1}, {1, 2}, {2, 2}};
  const std::vector<std::pair<float, float>> other = {{20, 0}, {21, 0}, {20, 1}};
  const RegionSet expected = regions_of("0 0, 9 0, 9 9, 0 9; 1 1, 1 2, 2 2 | 20 0, 21 0, 20 1");
  RegionBuilder builder;
  builder.add_polygon(shell, hole);
  builder.add_contour(other);
  EXPECT_EQ(builder.take(), expected);
  builder.begin_polygon();
  builder.add_contour(shell);
  builder.add_contour(hole);
  builder.begin_polygon();
  builder.add_contour(other);
  EXPECT_EQ(builder.regions(), expected);
  EXPECT_EQ(builder.take(), expected);
  EXPECT_TRUE(builder.take().empty());
  builder.add_contour(shell);
  builder.add_contour(other);
  EXPECT_EQ(builder.take().polygon_ends, (std::vector<std::uint32_t>{1, 2}));
  builder.begin_polygon();
  builder.begin_polygon();  // a polygon without contours is none
  EXPECT_TRUE(builder.take().polygon_ends.empty());
}

Error refusal(RegionBuilder& builder, const auto&... contours) {
  try {
    builder.add_polygon(contours...);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return {ErrorCode::bad_option, ""};
}

TEST(RegionBuilder, refusesWholeNumbersThatNoDoubleIs) {
  using Pair = std::array<std::int64_t, 2>;
  const std::int64_t most = std::int64_t{1} << 53;
  RegionBuilder builder;
  builder.add_polygon(std::vector<Pair>{{most, -most}, {most * 2, most + 2}, {INT64_MIN, most * 512}});
  EXPECT_EQ(builder.regions().points[2].x, -0x1p63);
  const RegionSet before = builder.regions();
  const std::vector<Pair> good = {{0, 0}, {1, 0}, {0, 1}};
  for (const std::int64_t bad : {most + 1, -most - 1, INT64_MAX, INT64_MIN + 1}) {
    const Error error = refusal(builder, good, std::vector<Pair>{{0, 0}, {1, bad}});
    EXPECT_EQ(error.code(), ErrorCode::out_of_domain);
    EXPECT_EQ(error.place().contour, 2u);
    EXPECT_EQ(error.place().vertex, 1u);
    EXPECT_EQ(builder.regions(), before);
  }
  const Error error = refusal(builder, std::vector<std::pair<std::uint64_t, int>>{{UINT64_MAX, 0}});
  EXPECT_EQ(error.code(), ErrorCode::out_of_domain);
  EXPECT_EQ(error.place().polygon, 1u);
  EXPECT_NO_THROW(builder.add_contour(std::vector<std::pair<std::uint64_t, int>>{{std::uint64_t{1} << 63, 0}}));
}

TEST(RegionBuilder, refusesWhatIsNoCoordinate) {
  RegionBuilder builder;
  EXPECT_EQ(refusal(builder, std::vector<Point>{{0, NAN}}).code(), ErrorCode::not_finite);
  EXPECT_EQ(refusal(builder, std::vector<WithMembers>{{INFINITY, 0, 0}}).code(), ErrorCode::not_finite);
  const Error error = refusal(builder, std::vector<Point>{{0, 0}, {1e91, 0}});
  EXPECT_EQ(error.code(), ErrorCode::out_of_domain);
  EXPECT_EQ(error.place().polygon, 0u);
  EXPECT_EQ(error.place().vertex, 1u);
  EXPECT_TRUE(builder.take().empty());
}

TEST(RegionBuilder, aRefusedContourLeavesThePolygonAsItWas) {
  RegionBuilder builder;
  builder.begin_polygon();
  builder.add_contour(std::vector<Point>{{0, 0}, {9, 0}, {0, 9}});
  try {
    builder.add_contour(std::vector<Point>{{1, 1}, {NAN, 0}});
    FAIL() << "a NaN was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.place().polygon, 0u);
    EXPECT_EQ(error.place().contour, 1u);
  }
  builder.add_contour(std::vector<Point>{{1, 1}, {2, 1}, {1, 2}});
  EXPECT_EQ(builder.take(), regions_of("0 0, 9 0, 0 9; 1 1, 2 1, 1 2"));
}

}  // namespace
}  // namespace oblast
