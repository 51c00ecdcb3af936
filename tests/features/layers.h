// Random layers: hostile operands cut into rows.
#pragma once

#include <oblast/features.h>

#include <cstdint>
#include <vector>

#include "generators/hostile.h"

namespace oblast::testing {

struct Layer {
  RegionSet regions;
  std::vector<std::uint32_t> feature_ends;

  operator FeatureView() const { return {regions, feature_ends}; }
};

struct Layers {
  Layer a, b;
};

/// The polygons of the operands, cut into rows at random places: rows of one polygon, of several, of none. They
/// overlap, repeat and touch as the generator had it.
Layers random_layers(const generators::Operands& operands, std::uint64_t seed);

/// The same rows with the polygons of each in another order, contours rotated and turned.
Layer shuffled_within_rows(const Layer& layer, std::uint64_t seed);

/// The layer with rows behind it that hold the polygons of `regions`; and with these alone, its own rows empty.
Layer with_rows(const Layer& layer, const RegionSet& regions);
Layer only_new_rows(const Layer& layer, const RegionSet& regions);

/// A random group for each feature, below `groups`.
std::vector<std::uint32_t> random_groups(const FeatureView& layer, std::uint32_t groups, std::uint64_t seed);

}  // namespace oblast::testing
