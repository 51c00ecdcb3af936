// Real layers of polygons, lines and points, each with half a million places at random, and as many on and beside
// borders (oblast_zone_layers runs all layers).
#include <gtest/gtest.h>

#include "zone_layers/layer_zones.h"

namespace oblast::testing {
namespace {

void expect_promises(const char* layer, const LayerTrial& trial) {
  const LayerFigures found = judge_layer(std::string(OBLAST_SHARED "/") + layer, trial);
  EXPECT_EQ(found.fault, "") << layer;
  EXPECT_GT(found.objects, 1u) << layer;
  EXPECT_GE(found.places, trial.places) << layer;
  EXPECT_LE(found.seen, found.error + found.rounding) << layer;
}

TEST(ZoneLayers, Buildings) { expect_promises("realworld/bubenec.gpkg:buildings", {.places = 500'000}); }
TEST(ZoneLayers, Streets) { expect_promises("realworld/bubenec.gpkg:streets", {.places = 500'000, .seed = 2}); }
TEST(ZoneLayers, Cities) { expect_promises("geopandas/naturalearth_cities", {.places = 500'000, .seed = 3}); }

TEST(ZoneLayers, FineTolerance) {
  expect_promises("realworld/bubenec.gpkg:streets", {.relative_tolerance = 1e-7, .places = 10'000});
}

}  // namespace
}  // namespace oblast::testing
