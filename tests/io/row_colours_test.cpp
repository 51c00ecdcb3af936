#include "io/row_colours.h"

#include <gtest/gtest.h>

#include "io/row_neighbours.h"

namespace oblast::io {
namespace {

/// Rows of so many unit squares each.
struct Rows {
  RegionSet regions;
  std::vector<std::uint32_t> ends;

  explicit Rows(const std::vector<int>& sizes) {
    for (const int size : sizes) {
      for (int i = 0; i < size; ++i) {
        const double x = 2.0 * static_cast<double>(regions.polygon_ends.size());
        for (const Point p : {Point{x, 0}, Point{x + 1, 0}, Point{x + 1, 1}, Point{x, 1}}) regions.points.push_back(p);
        regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
        regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
      }
      ends.push_back(static_cast<std::uint32_t>(regions.polygon_ends.size()));
    }
  }
  operator FeatureView() const { return {regions, ends}; }
};

std::vector<std::string> labels(const std::vector<PictureClass>& classes) {
  std::vector<std::string> found;
  found.reserve(classes.size());
  for (const PictureClass& c : classes) found.push_back(c.label);
  return found;
}

TEST(RowColours, FewNumbersHaveAClassEach) {
  const Rows rows({1, 1, 1, 0});
  const std::vector<double> numbers{3, 1, 3, 9};
  const auto classes = classes_by_number(rows, numbers);
  EXPECT_EQ(labels(classes), (std::vector<std::string>{"1", "3"})) << "a row without polygons has no class";
  EXPECT_EQ(classes[1].regions.polygon_ends.size(), 2U);
}

TEST(RowColours, ManyNumbersShareClassesOfAboutEquallyManyPolygons) {
  std::vector<int> sizes(100, 1);
  sizes[0] = 600;
  const Rows rows(sizes);
  std::vector<double> numbers;
  numbers.reserve(100);
  for (int i = 0; i < 100; ++i) numbers.push_back(i);
  const auto classes = classes_by_number(rows, numbers);
  EXPECT_EQ(classes.front().label, "0");
  EXPECT_EQ(classes.front().regions.polygon_ends.size(), 600U);
  std::size_t polygons = 0;
  for (const PictureClass& c : classes) polygons += c.regions.polygon_ends.size();
  EXPECT_EQ(polygons, 699U);
  EXPECT_LE(classes.size(), 7U);
}

TEST(RowColours, RareTextsShareAClass) {
  const Rows rows(std::vector<int>(12, 1));
  const std::vector<std::string> texts{"a", "b", "c", "d", "e", "f", "g", "g", "h", "i", "j", ""};
  const auto classes = classes_by_text(rows, texts);
  ASSERT_EQ(classes.size(), 8U);
  EXPECT_EQ(classes[0].label, "g");
  EXPECT_EQ(classes[1].label, "(none)");
  EXPECT_EQ(classes[7].label, "4 others");
  EXPECT_EQ(classes[7].regions.polygon_ends.size(), 4U);
}

/// A board of unit squares, a row each.
Rows board(int width, int height) {
  Rows rows(std::vector<int>(static_cast<std::size_t>(width * height), 1));
  for (std::size_t p = 0; p < rows.ends.size(); ++p) {
    const auto column = static_cast<double>(static_cast<int>(p) % width),
               line = static_cast<double>(static_cast<int>(p) / width);
    const Point corners[] = {{column, line}, {column + 1, line}, {column + 1, line + 1}, {column, line + 1}};
    std::copy(corners, corners + 4, rows.regions.points.begin() + static_cast<std::ptrdiff_t>(4 * p));
  }
  return rows;
}

TEST(RowColours, NeighboursDiffer) {
  const Rows rows = board(5, 4);
  const auto pairs = neighbours_of(rows);
  EXPECT_EQ(pairs.size(), 31U) << "corners do not count";
  EXPECT_EQ(pairs.front(), std::pair(0U, 1U));
  EXPECT_EQ(pairs.back(), std::pair(18U, 19U));
  const auto classes = classes_by_neighbours(rows, "zones");
  EXPECT_EQ(labels(classes), (std::vector<std::string>{"", "zones"})) << "as a chess board";
  for (const PictureClass& c : classes) {
    EXPECT_EQ(c.regions.polygon_ends.size(), 10U);
    for (std::size_t p = 0; p < 10; ++p) {
      const Point corner = c.regions.points[4 * p];
      EXPECT_EQ(static_cast<int>(corner.x + corner.y) % 2 == 0, &c == classes.data());
    }
  }
}

TEST(RowColours, ARowDoesNotNeighbourItself) {
  const Rows two = board(2, 1);
  const std::uint32_t ends[] = {2};
  EXPECT_TRUE(neighbours_of({two.regions, ends}).empty());
}

TEST(RowColours, NothingHasNoClass) {
  EXPECT_TRUE(classes_by_neighbours(Rows({}), "zones").empty());
  EXPECT_TRUE(classes_by_number(Rows({}), {}).empty());
  EXPECT_TRUE(classes_by_text(Rows({}), {}).empty());
}

}  // namespace
}  // namespace oblast::io
