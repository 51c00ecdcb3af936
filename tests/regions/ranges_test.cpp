// Polygons and contours as ranges, and views of a part of larger arrays in every function that takes regions.
#include <gtest/gtest.h>
#include <oblast/classics.h>
#include <oblast/hull.h>
#include <oblast/layers.h>
#include <oblast/oblast.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "generators/hostile.h"
#include "verify/text_regions.h"

namespace oblast::internal {
namespace {

using verify::regions_of;

static_assert(std::random_access_iterator<ContourRange::Iterator>);
static_assert(std::random_access_iterator<PolygonRange::Iterator>);
static_assert(std::is_aggregate_v<RegionView> && std::is_trivially_copyable_v<RegionView>);

RegionSet copied(const RegionView& view) {
  RegionSet copy;
  for (const PolygonView polygon : view.polygons()) {
    for (const std::span<const Point> contour : polygon.contours()) {
      copy.points.insert(copy.points.end(), contour.begin(), contour.end());
      copy.contour_ends.push_back(static_cast<std::uint32_t>(copy.points.size()));
    }
    copy.polygon_ends.push_back(static_cast<std::uint32_t>(copy.contour_ends.size()));
  }
  return copy;
}

/// A view of polygons [begin, end) of `all`, with the offsets of all.
RegionView part(const RegionView& all, std::size_t begin, std::size_t end) {
  RegionView view = all.contours_between(all.polygon_begin(begin), all.polygon_end(end - 1));
  if (all.polygon_ends.empty()) return view;
  view.polygon_ends = all.polygon_ends.subspan(begin, end - begin);
  view.first_contour = all.first_contour + all.polygon_begin(begin);
  return view;
}

RegionSet sample() { return regions_of("0 0, 1 0, 0 1 | 5 0, 9 0, 9 9, 5 9; 6 1, 7 1, 6 2 | 2 2, 3 2, 3 3, 2 3"); }

TEST(Ranges, walkPolygonsAndContours) {
  const RegionSet set = sample();
  std::vector<std::size_t> sizes;
  for (auto polygon : set.polygons()) {
    sizes.push_back(polygon.contour_count() * 100);
    for (auto contour : polygon.contours()) sizes.push_back(contour.size());
  }
  EXPECT_EQ(sizes, (std::vector<std::size_t>{100, 3, 200, 4, 3, 100, 4}));
  EXPECT_EQ(set.polygons().size(), 3u);
  EXPECT_EQ(set.contours().size(), 4u);
  EXPECT_EQ(set.polygon(1).contour(1)[0], (Point{6, 1}));
  EXPECT_TRUE(RegionSet{}.view().polygons().empty());
}

TEST(Ranges, withoutPolygonEndsEachContourIsAPolygon) {
  RegionSet set = sample();
  set.polygon_ends.clear();
  EXPECT_EQ(set.polygons().size(), 4u);
  EXPECT_EQ(set.polygon(2).contour(0)[0], (Point{6, 1}));
  EXPECT_EQ(set.polygon(2).view().polygon(0).contour_count(), 1u);
}

TEST(Ranges, serveTheAlgorithmsOfTheLibrary) {
  const RegionSet set = sample();
  const auto holed =
      std::ranges::find_if(set.polygons(), [](const PolygonView& polygon) { return polygon.contour_count() > 1; });
  EXPECT_EQ((*holed).contour(0)[0], (Point{5, 0}));
  const auto contours = set.contours();
  EXPECT_EQ(std::ranges::count_if(contours, [](std::span<const Point> c) { return c.size() == 3; }), 2);
  EXPECT_EQ(contours.end()[-1][0], (Point{2, 2}));
}

TEST(Ranges, emptyPolygonsAndContoursAreThere) {
  const RegionSet set{{{0, 0}, {1, 0}, {0, 1}}, {0, 3, 3}, {0, 2, 2, 3}};
  std::vector<std::size_t> counts;
  for (auto polygon : set.polygons()) counts.push_back(polygon.contour_count());
  EXPECT_EQ(counts, (std::vector<std::size_t>{0, 2, 0, 1}));
  for (auto polygon : set.polygons()) EXPECT_EQ(unite(polygon), unite(copied(polygon)));
}

TEST(Ranges, partsHaveParts) {
  const RegionSet set = sample();
  const RegionView tail = part(set, 1, 3);
  EXPECT_EQ(copied(tail.polygon(1)), copied(set.polygon(2)));
  EXPECT_EQ(copied(part(tail, 1, 2)), copied(set.polygon(2)));
  EXPECT_EQ(tail.polygon(0).view().contour(1)[0], (Point{6, 1}));
}

TEST(Ranges, offsetsOfPartsAreChecked) {
  const RegionSet set = sample();
  RegionView view = set.polygon(1);
  EXPECT_EQ(signed_area(view), 36 + 0.5);
  const auto is_refused = [](const RegionView& wrong) {
    try {
      (void)unite(wrong);
    } catch (const Error& error) {
      return error.code() == ErrorCode::bad_offsets;
    }
    return false;
  };
  RegionView wrong = view;
  wrong.first_point = 0;
  EXPECT_TRUE(is_refused(wrong));
  wrong = view;
  wrong.first_contour = 0;
  EXPECT_TRUE(is_refused(wrong));
  wrong = view;
  wrong.first_point = 9;  // past the first end
  EXPECT_TRUE(is_refused(wrong));
  wrong.points = wrong.points.first(1);  // and so that the last one is right
  EXPECT_TRUE(is_refused(wrong));
  wrong = view;
  wrong.first_contour = 3;
  EXPECT_TRUE(is_refused(wrong));
}

TEST(Ranges, placesOfFaultsCountFromThePart) {
  RegionSet set = sample();
  set.points[8].x = std::nan("");  // the second vertex of the hole of polygon 1
  try {
    (void)unite(part(set, 1, 3));
    FAIL() << "a NaN was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.place().polygon, 0u);
    EXPECT_EQ(error.place().contour, 1u);
    EXPECT_EQ(error.place().vertex, 1u);
  }
}

TEST(Ranges, partsGiveTheBytesOfCopies) {
  for (const auto& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto [a, b] = generator.make(seed, generator.usual);
      const RegionView views[] = {a, b};
      for (const RegionView& all : views) {
        const std::size_t count = all.polygon_count();
        if (count == 0) continue;
        const RegionView left = part(all, 0, count / 2 + 1), right = part(all, count / 2, count);
        const RegionSet left_copy = copied(left), right_copy = copied(right);
        for (const Operation operation : {Operation::intersection, Operation::symmetric_difference})
          EXPECT_EQ(overlay(left, right, operation), overlay(left_copy, right_copy, operation)) << generator.name;
        Options even_odd;
        even_odd.fill_a = FillRule::even_odd();
        EXPECT_EQ(unite(right, even_odd), unite(right_copy, even_odd)) << generator.name;
        EXPECT_EQ(hull(right), hull(right_copy)) << generator.name;
        EXPECT_EQ(layers(right), layers(right_copy)) << generator.name;
        EXPECT_EQ(signed_area(right), signed_area(right_copy)) << generator.name;
        EXPECT_EQ(triangulate(right).triangles, triangulate(right_copy).triangles) << generator.name;
        EXPECT_EQ(ClipWindow(-1, -1, 1, 1).clip(right), ClipWindow(-1, -1, 1, 1).clip(right_copy)) << generator.name;
      }
    }
  }
}

TEST(Ranges, resultsAreTriangulatedAndClippedAsParts) {
  const RegionSet set = unite(sample());
  TriangulateOptions options;
  options.input = TriangleInput::result;
  for (std::size_t p = 0; p < set.polygon_ends.size(); ++p) {
    const RegionSet copy = copied(set.polygon(p));
    EXPECT_EQ(triangulate(set.polygon(p), options).regions, copy);
    EXPECT_EQ(sutherland_hodgman(set.polygon(p), regions_of("0 0, 8 0, 8 8, 0 8")),
              sutherland_hodgman(copy, regions_of("0 0, 8 0, 8 8, 0 8")));
    if (copy.points.size() == 4) {
      EXPECT_EQ(ClipWindow(set.polygon(p)).clip(set), ClipWindow(copy).clip(set));
    }
  }
}

}  // namespace
}  // namespace oblast::internal
