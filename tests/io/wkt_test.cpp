// Well-Known Text: what is accepted, counted and refused, and the place in the message.
#include <string>

#include "io/crs.h"
#include "io_support.h"

namespace oblast::io {
namespace {

Layer wkt(const std::string& text, OtherGeometry other = OtherGeometry::count_and_skip) {
  ReadOptions options;
  options.other = other;
  return read_wkt(text, "in.wkt", options);
}

std::string wkt_error(const std::string& text, OtherGeometry other = OtherGeometry::count_and_skip) {
  try {
    wkt(text, other);
  } catch (const IoError& error) {
    return error.what();
  }
  return {};
}

TEST(Wkt, PolygonWithHole) {
  const Layer layer = wkt("POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 2 2))");
  EXPECT_EQ(layer.regions.contour_ends, (std::vector<std::uint32_t>{4, 7}));
  EXPECT_EQ(layer.regions.polygon_ends, (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(layer.regions.points[4], (Point{2, 2}));
}

TEST(Wkt, MultipolygonsCollectionsAndSeveralLines) {
  const Layer layer =
      wkt("multipolygon(((0 0,1 0,1 1)),((5 5,6 5,6 6,5 5)))\n"
          "GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), GEOMETRYCOLLECTION (POLYGON ((2 2, 3 2, 2 3, 2 2)), "
          "MULTIPOLYGON EMPTY))\r\n"
          "POLYGON ((9 9, 10 9, 9 10, 9 9));");
  EXPECT_EQ(layer.regions.polygon_ends.size(), 5U);
  ASSERT_EQ(layer.features.size(), 3U);
  EXPECT_EQ(layer.features[1].first_polygon, 2U);
  EXPECT_EQ(layer.features[2].feature, 2);
  EXPECT_EQ(layer.report.unclosed_contours, 1U);
}

TEST(Wkt, SridsNameTheCoordinateSystem) {
  const std::string triangle = "POLYGON ((9 9, 10 9, 9 10, 9 9));\n", there = "SRID=3035;" + triangle;
  EXPECT_TRUE(mentions(crs_name(wkt(there + there).crs_wkt), {"EPSG:3035"}));
  EXPECT_EQ(wkt("SRID=0;" + triangle + triangle).crs_wkt, "");
  EXPECT_TRUE(mentions(wkt_error(there + triangle), {"line 2", "no SRID", "SRID=3035"}));
  EXPECT_TRUE(mentions(wkt_error(there + "srid = 4326;" + triangle), {"line 2", "SRID=4326", "SRID=3035"}));
  EXPECT_TRUE(mentions(wkt_error("SRID=999999;" + triangle), {"line 1", "SRID=999999", "PROJ"}));
  EXPECT_TRUE(mentions(wkt_error("SRID=x;" + triangle), {"column 6", "number"}));
}

TEST(Wkt, AMissingCommaIsAnError) {
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 4 0, 4 4 0 4, 0 0))"), {"line 1, column 25", "comma"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 4 0, 4 4, 0 4 9, 0 0))"), {"column 30", "comma"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON Z ((0 0 1, 4 0 1, 4 4, 0 0 1))"), {"two numbers", "three"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0 1, 4 0 1, 4 4, 0 0 1))"), {"two numbers", "three"}));
  // As PostGIS writes Z and M.
  EXPECT_EQ(wkt("POLYGON ((0 0 1 2, 4 0 1 2, 4 4 1 2, 0 0 1 2))").report.with_m, 1U);
}

TEST(Wkt, EmptyGeometriesAreCounted) {
  const Layer layer = wkt("POLYGON EMPTY\nMULTIPOLYGON EMPTY\nGEOMETRYCOLLECTION EMPTY\nPOLYGON Z EMPTY\n");
  EXPECT_TRUE(layer.regions.empty());
  EXPECT_EQ(layer.report.empty_geometries, 4U);
  EXPECT_EQ(layer.report.features, 4U);
}

TEST(Wkt, NoTextIsNoGeometry) {
  EXPECT_EQ(wkt("").report.features, 0U);
  EXPECT_EQ(wkt(" \n\t\r\n").report.features, 0U);
  ReadOptions options;
  options.assume_crs = crs_from_text("EPSG:3035");
  EXPECT_TRUE(same_crs(read_wkt("", "in.wkt", options).crs_wkt, options.assume_crs));
}

TEST(Wkt, HeightsAndMeasuresAreDroppedAndCounted) {
  const Layer layer =
      wkt("POLYGON Z ((0 0 5, 1 0 5, 0 1 5, 0 0 5))\nPOLYGON M ((0 0 5, 1 0 5, 0 1 5, 0 0 5))\n"
          "POLYGONZM ((0 0 5 6, 1 0 5 6, 0 1 5 6, 0 0 5 6))\nPOLYGON ((0 0 5, 1 0 5, 0 1 5, 0 0 5))");
  EXPECT_EQ(layer.report.with_z, 3U);
  EXPECT_EQ(layer.report.with_m, 2U);
  EXPECT_EQ(layer.regions.points.size(), 12U);
  EXPECT_EQ(layer.regions.points[4], (Point{1, 0}));
}

TEST(Wkt, RepeatedVerticesAreDroppedAndCounted) {
  const Layer layer = wkt("POLYGON ((0 0, 0 0, 1 0, 1 0, 1 0, 0 1, 0 0, 0 0))");
  EXPECT_EQ(layer.regions.points, (std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(layer.report.repeated_vertices, 4U);
}

TEST(Wkt, DegenerateRingsStay) {
  const Layer layer = wkt("POLYGON ((1 1, 1 1, 1 1))\nPOLYGON ((0 0, 5 5, 0 0))");
  EXPECT_EQ(layer.regions.contour_ends, (std::vector<std::uint32_t>{1, 3}));
}

TEST(Wkt, LinesAndPointsAreCountedOrRefused) {
  const std::string text = "LINESTRING (0 0, 1 1)\nPOINT (1 1)\nMULTIPOINT ((0 0), (1 1))\nPOLYGON ((0 0, 1 0, 0 1))";
  const Layer layer = wkt(text);
  EXPECT_EQ(layer.report.lines, 1U);
  EXPECT_EQ(layer.report.points, 2U);
  EXPECT_EQ(layer.report.empty_geometries, 0U);
  EXPECT_EQ(layer.regions.polygon_ends.size(), 1U);
  EXPECT_TRUE(mentions(wkt_error(text, OtherGeometry::refuse), {"in.wkt", "feature 0", "LINESTRING"}));
}

TEST(Wkt, CurvesAreRefused) {
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1 0, 0 1))\nCURVEPOLYGON (CIRCULARSTRING (0 0, 1 1, 2 0, 1 -1, 0 0))"),
                       {"in.wkt", "feature 1", "line 2", "CURVEPOLYGON", "curve"}));
  EXPECT_TRUE(mentions(wkt_error("MULTISURFACE (((0 0, 1 0, 0 1, 0 0)))"), {"feature 0", "MULTISURFACE"}));
  EXPECT_TRUE(mentions(wkt_error("TIN (((0 0, 1 0, 0 1, 0 0)))"), {"feature 0", "TIN"}));
}

TEST(Wkt, SyntaxFaultsNameLineAndColumn) {
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1 0, 0 x))"), {"in.wkt, line 1, column 23", "number"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1 0, 0 1))\n\n  HELLO"), {"line 3, column 3", "HELLO"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1 0, 0 1)"), {"line 1, column 25", "')'", "end of the text"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1, 0 1))"), {"column 17", "number"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1.2.3 1, 0 1))"), {"column 16", "number"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0 1 2 3, 1 1))"), {"four numbers"}));
  EXPECT_TRUE(mentions(wkt_error("LINESTRING (0 0, 1 1"), {"parenthesis"}));
  EXPECT_TRUE(mentions(wkt_error("123"), {"column 1", "geometry type"}));
}

TEST(Wkt, BadCoordinatesNameTheVertex) {
  const std::string text =
      "POLYGON ((0 0, 1 0, 0 1))\nMULTIPOLYGON (((0 0, 1 0, 0 1)), ((0 0, 9 0, 9 9, 0 0), (1 1, 2 1, nan 2, 1 1)))";
  EXPECT_TRUE(
      mentions(wkt_error(text), {"in.wkt, feature 1", "line 2", "part 2", "ring 2", "vertex 2", "x is not a number"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1 -inf, 0 1))"), {"ring 1, vertex 1", "y is infinite"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1e200 0, 0 1))"), {"vertex 1", "1e+200", "domain"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1e-200 0, 0 1))"), {"vertex 1", "domain"}));
  EXPECT_TRUE(mentions(wkt_error("POLYGON ((0 0, 1e999 0, 0 1))"), {"line 1, column 16", "range of a double"}));
}

TEST(Wkt, DeepNestingNeedsNoStack) {
  std::string text;
  constexpr int depth = 300000;
  for (int i = 0; i < depth; ++i) text += "GEOMETRYCOLLECTION (";
  text += "POLYGON ((0 0, 1 0, 0 1))" + std::string(depth, ')');
  EXPECT_EQ(wkt(text).regions.points.size(), 3U);
}

TEST(Wkt, PrintedShortestAndClosed) {
  EXPECT_EQ(to_wkt(RegionSet{}), "POLYGON EMPTY");
  EXPECT_EQ(to_wkt(one_triangle()), "MULTIPOLYGON (((0 0, 4 0, 0 3, 0 0)))");
  EXPECT_EQ(to_wkt(square_with_hole()),
            "MULTIPOLYGON (((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 6, 6 6, 6 2, 2 2)), ((10 0, 12 0, 12 1, 10 0)))");
  EXPECT_EQ(to_wkt(RegionSet{{{0.1, -1e-7}, {1e300, 0}, {1, 1}}, {3}, {1}}),
            "MULTIPOLYGON (((0.1 -1e-07, 1e+300 0, 1 1, 0.1 -1e-07)))");
}

TEST(Wkt, RandomPolygonsReadBackToTheSameBits) {
  const RegionSet regions = scattered(2000, 11);
  EXPECT_TRUE(same_bits(regions, wkt(to_wkt(regions)).regions));
}

}  // namespace
}  // namespace oblast::io
