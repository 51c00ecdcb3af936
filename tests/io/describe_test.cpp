// Converts a place in the arrays to file, feature, part, ring and vertex.
#include <gtest/gtest.h>

#include "io/layer.h"
#include "io/read.h"

namespace oblast::io {
namespace {

Place place(std::size_t polygon, std::size_t contour, std::size_t vertex) { return {0, polygon, contour, vertex}; }

TEST(Describe, FileFeaturePartRingVertex) {
  const Layer layer = read_wkt(
      "POLYGON ((0 0, 1 0, 0 1))\nPOINT (0 0)\n"
      "MULTIPOLYGON (((0 0, 9 0, 0 9), (1 1, 2 1, 1 2)), ((20 0, 29 0, 20 9), (21 1, 22 1, 21 2)))\n",
      "fires/0412.wkt");
  EXPECT_EQ(describe(layer, place(0, 0, 2)), "fires/0412.wkt, feature 0, part 1, ring 1, vertex 2");
  EXPECT_EQ(describe(layer, place(1, 2, 0)), "fires/0412.wkt, feature 2, part 1, ring 2, vertex 0");
  EXPECT_EQ(describe(layer, place(2, 4, 1)), "fires/0412.wkt, feature 2, part 2, ring 2, vertex 1");
  EXPECT_EQ(describe(layer, place(2, Place::npos, Place::npos)), "fires/0412.wkt, feature 2, part 2");
  EXPECT_EQ(describe(layer, place(Place::npos, 3, 1)), "fires/0412.wkt, feature 2, part 2, ring 1, vertex 1");
  EXPECT_EQ(describe(layer, {}), "fires/0412.wkt");
}

}  // namespace
}  // namespace oblast::io
