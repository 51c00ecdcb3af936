// Pictures are well-formed, complete, and small for any input.
#include "io/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>

#include "io/layer.h"
#include "io/picture_file.h"
#include "io/picture_header.h"
#include "io/picture_marks.h"

namespace oblast::io {
namespace {

constexpr std::size_t largest_picture = 4'500'000;  // bytes

RegionSet square(double x, double y, double side) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {4}, {1}};
}

void append(RegionSet& to, const RegionSet& one) {
  to.points.insert(to.points.end(), one.points.begin(), one.points.end());
  to.contour_ends.push_back(static_cast<std::uint32_t>(to.points.size()));
  to.polygon_ends.push_back(static_cast<std::uint32_t>(to.contour_ends.size()));
}

// Checks that elements are properly nested, which is enough XML for this writer.
bool well_formed(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    if (end == std::string::npos) return false;
    if (svg[end - 1] == '/') continue;
    const bool closes = svg[at + 1] == '/';
    const std::size_t begin = at + (closes ? 2 : 1);
    const std::string name = svg.substr(begin, svg.find_first_of(" \n>", begin) - begin);
    if (!closes) {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Picture, ShowsOperandsResultAndLegend) {
  const RegionSet a = square(0, 0, 2), b = square(1, 1, 2), result = square(1, 1, 1);
  Picture picture{a, b, result, "A & B < C", "first", "second", "intersection"};
  const std::string svg = to_svg(picture);
  EXPECT_TRUE(well_formed(svg)) << svg;
  EXPECT_NE(svg.find("A &amp; B &lt; C"), std::string::npos);
  EXPECT_NE(svg.find("first: 1 contour, 4 vertices"), std::string::npos);
  EXPECT_NE(svg.find("second: "), std::string::npos);
  EXPECT_NE(svg.find("intersection: "), std::string::npos);
  EXPECT_EQ(count(svg, "clipPath id="), 1u);  // nothing needs enlarging
}

TEST(Picture, LinesAndMarksLieOverTheRegions) {
  const RegionSet result = square(0, 0, 10);
  const std::vector<Point> vertices{{0, 0}, {10, 10}, {5, 0}, {5, 10}, {5, 20}};
  const std::vector<std::uint32_t> ends{2, 5};
  Picture picture;
  picture.result = result;
  picture.label_a = "roads";
  picture.lines = {vertices, ends};
  picture.marks = {{{{1, 1}, {2, 30}}, "#d55e00", "stops <2>"}, {{}, "#000000", "none"}};
  const std::string svg = to_svg(picture);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(count(svg, "roads: 2 lines, 5 vertices"), 1u);
  EXPECT_EQ(count(svg, "stops &lt;2&gt;"), 1u);
  EXPECT_EQ(count(svg, "A: 0 contours"), 0u);  // there are no regions of the operand
  const auto fill = svg.find(colour_result, svg.find("clip-path")),
             line = svg.find("stroke=\"#1b4f77\" stroke-width=\"15\"");
  const auto mark = svg.find("stroke=\"#d55e00\"");
  EXPECT_NE(fill, std::string::npos);
  EXPECT_LT(fill, line);
  EXPECT_LT(line, mark);
  EXPECT_NE(mark, std::string::npos);
  const auto dots = svg.rfind("d=\"M", mark);
  EXPECT_EQ(count(svg.substr(dots, mark - dots), "h0"), 2u);  // the upper mark makes the picture higher
}

// The first line is drawn to the sides of the panel only.
TEST(Picture, LinesBeyondThePanelAreCut) {
  const std::vector<Point> vertices{{-1e9, 5}, {1e9, 5}};
  const std::vector<std::uint32_t> ends{2};
  const Frame frame = fit({0, 0, 10, 10}, 1, {100, 50, 200, 200});
  const std::string path = draw_lines({vertices, ends}, frame, "#000", 1);
  EXPECT_TRUE(path.starts_with("<path d=\"M950 1500L3050 1500\"")) << path;
  const std::vector<Point> outside{{-5, 20}, {20, 21}};
  EXPECT_EQ(draw_lines({outside, ends}, frame, "#000", 1), "");
}

TEST(Picture, ManyLinesAndMarksMakeASmallPicture) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0, 1000);
  std::vector<Point> points;
  std::vector<std::uint32_t> ends;
  for (int i = 0; i < 400'000; ++i) {
    points.push_back({anywhere(random), anywhere(random)});
    if (i % 2) ends.push_back(static_cast<std::uint32_t>(points.size()));
  }
  Picture picture;
  picture.lines = {points, ends};
  picture.marks = {{points, "#d55e00", "many"}};
  EXPECT_LT(to_svg(picture).size(), 12'000'000u);
}

// A million vertices on the left, three marks on the right: these are enlarged.
TEST(Picture, TheMarksAreEnlarged) {
  RegionSet a;
  for (int i = 0; i < 2000; ++i) append(a, square(i % 50 * 1e-3, i / 50 * 1e-3, 5e-4));
  append(a, square(100, 0, 1e-3));
  Picture picture;
  picture.a = a;
  picture.marks = {{{{100, 0}, {100, 5e-4}, {100, 1e-3}}, "#d55e00", "faults", 7}, {a.points, "#888", "notes", 4}};
  const std::string svg = to_svg(picture);
  const auto zoom = svg.find("clipPath id=\"zoom\"");
  ASSERT_NE(zoom, std::string::npos);
  const auto marks = svg.find("stroke=\"#d55e00\"", zoom);
  ASSERT_NE(marks, std::string::npos);
  EXPECT_GE(count(svg.substr(zoom, marks - zoom), "h0"), 2u);
}

TEST(Picture, OfNothingIsStillAPicture) {
  EXPECT_TRUE(well_formed(to_svg(Picture{})));
  const RegionSet flat{{{1, 1}, {1, 1}, {1, 1}}, {3}, {1}};
  Picture picture;
  picture.a = flat;
  EXPECT_TRUE(well_formed(to_svg(picture)));
}

TEST(Picture, ExtremeCoordinatesAreDrawn) {
  for (const double scale : {0x1p-290, 1.0, 0x1p290}) {
    const RegionSet a = square(-scale, -scale, 2 * scale);
    Picture picture;
    picture.a = a;
    picture.result = a;
    const std::string svg = to_svg(picture);
    EXPECT_TRUE(well_formed(svg));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_LT(svg.size(), 20'000u);
  }
  const RegionSet far = square(1e15, 1e15, 1);  // ticks closer than numbers can be
  Picture picture;
  picture.a = far;
  EXPECT_LT(to_svg(picture).size(), 20'000u);
}

TEST(Picture, LongitudesAreSqueezedByTheLatitude) {
  const auto path_of = [](MapProjection projection) {
    const RegionSet a = square(10, 59, 2);
    Picture picture;
    picture.a = a;
    picture.projection = projection;
    std::smatch match;
    const std::string svg = to_svg(picture);
    EXPECT_TRUE(
        std::regex_search(svg, match, std::regex("<path d=\"M(-?\\d+) (-?\\d+)l(-?\\d+) (-?\\d+) (-?\\d+)(-\\d+)")));
    return std::abs(std::stod(match[3]) / std::stod(match[6]));
  };
  EXPECT_NEAR(path_of(MapProjection::plane), 1, 0.01);
  EXPECT_NEAR(path_of(MapProjection::longitude_latitude), 0.5, 0.01);
}

TEST(Picture, SpecksAreGatheredSaidAndEnlarged) {
  RegionSet specks;
  std::mt19937 random(5);
  for (int k = 0; k < 200'000; ++k)
    append(specks, square(static_cast<double>(random() % 1'000'000), static_cast<double>(random() % 500'000), 20));
  for (int k = 0; k < 50; ++k) append(specks, square(700'000 + 15 * (k % 10), 300'000 + 15 * (k / 10), 20));
  Picture picture;
  picture.a = specks;
  picture.result = specks;
  const std::string svg = to_svg(picture);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_LT(svg.size(), largest_picture);
  EXPECT_NE(svg.find("400,100 contours below a pixel: the stronger the colour"), std::string::npos);
  EXPECT_EQ(count(svg, "clipPath id="), 2u);
  EXPECT_NE(svg.find(">enlarged<"), std::string::npos);
}

TEST(Picture, AMillionVerticesStaySmall) {
  RegionSet wiggly;
  constexpr int n = 1'000'000;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * 3.14159265358979 * k / n,
                 radius = 1 + 0.3 * std::sin(997 * angle) + 0.1 * std::sin(31013 * angle);
    wiggly.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  wiggly.contour_ends = {n};
  wiggly.polygon_ends = {1};
  Picture picture{wiggly, wiggly, wiggly, "", "", "", ""};
  const std::string svg = to_svg(picture);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_LT(svg.size(), largest_picture);
}

TEST(Picture, ManyLargeContoursAreLeftOutAloud) {
  RegionSet stack;
  std::mt19937 random(6);
  for (int k = 0; k < 300'000; ++k)
    append(stack, square(static_cast<double>(random() % 1000), static_cast<double>(random() % 1000),
                         100 + static_cast<double>(random() % 1000)));
  Picture picture;
  picture.a = stack;
  const std::string svg = to_svg(picture);
  EXPECT_LT(svg.size(), largest_picture);
  EXPECT_NE(svg.find("left out, because the picture would become too large"), std::string::npos);
}

// Operands are not drawn then, so a place where only they have many vertices shows nothing.
TEST(Picture, OfClassesEnlargesAPlaceOfTheClasses) {
  RegionSet operand, rows;
  for (int k = 0; k < 5000; ++k) append(operand, square(100 + k % 70, 100 + k / 70, 0.5));
  append(rows, square(0, 0, 1000));
  for (int k = 0; k < 900; ++k) append(rows, square(900 + k % 30, 500 + k / 30, 0.5));
  Picture picture;
  picture.a = operand;
  picture.classes.push_back({rows, "#0072b2", "row"});
  const std::string svg = to_svg(picture);
  std::smatch label;
  ASSERT_TRUE(std::regex_search(svg, label, std::regex("<text x=\"([0-9.]+)\"[^>]*>enlarged<")));
  std::smatch panel;
  ASSERT_TRUE(std::regex_search(svg, panel, std::regex("<rect x=\"([0-9.]+)\" y=\"[0-9.]+\" width=\"([0-9.]+)\"")));
  EXPECT_GT(std::stod(label[1]), std::stod(panel[1]) + std::stod(panel[2]) / 2);
}

TEST(Picture, WritesAllOrNothing) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("oblast-picture-" + std::to_string(std::random_device{}()));
  std::filesystem::create_directory(folder);
  const std::string path = (folder / "p.svg").string();
  write_picture(path, to_svg(Picture{}));
  EXPECT_THROW(write_picture(path, to_svg(Picture{})), IoError);
  EXPECT_THROW(check_picture_writable(path), IoError);
  EXPECT_NO_THROW(write_picture(path, to_svg(Picture{}), Existing::overwrite));
  EXPECT_THROW(check_picture_writable((folder / "none/p.svg").string()), IoError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace oblast::io
