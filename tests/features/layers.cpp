#include "features/layers.h"

#include "generators/company.h"
#include "generators/random.h"
#include "generators/trial.h"
#include "verify/rows.h"

namespace oblast::testing {
namespace {

using generators::Random;

Layer cut_into_rows(const RegionSet& regions, Random& random) {
  Layer layer{regions, {}};
  const std::size_t count = RegionView(regions).polygon_count();
  const int most = random.one_in(3) ? 8 : 2;
  std::uint32_t end = 0;
  while (end < count) {
    if (random.one_in(8)) layer.feature_ends.push_back(end);
    end = std::min(static_cast<std::uint32_t>(count), end + static_cast<std::uint32_t>(random.between(1, most)));
    layer.feature_ends.push_back(end);
  }
  if (random.one_in(8)) layer.feature_ends.push_back(end);
  return layer;
}

void append_rows(Layer& layer, const RegionSet& regions) {
  for (std::size_t p = 0; p < RegionView(regions).polygon_count(); ++p) {
    generators::append_polygon(layer.regions, regions, p);
    if (p % 3 != 1) layer.feature_ends.push_back(static_cast<std::uint32_t>(layer.regions.polygon_ends.size()));
  }
  const auto count = static_cast<std::uint32_t>(layer.regions.polygon_ends.size());
  if (layer.feature_ends.empty() || layer.feature_ends.back() != count) layer.feature_ends.push_back(count);
}

}  // namespace

Layers random_layers(const generators::Operands& operands, std::uint64_t seed) {
  Random random(seed ^ 0x726f7773);
  return {cut_into_rows(operands.a, random), cut_into_rows(operands.b, random)};
}

Layer shuffled_within_rows(const Layer& layer, std::uint64_t seed) {
  Layer result;
  for (std::size_t f = 0; f < layer.feature_ends.size(); ++f) {
    const RegionView row = verify::regions_of(layer, f);
    RegionSet own;
    generators::append(own, row);
    generators::append(result.regions, generators::shuffled(own, FillRule::polygons(), seed + f));
    result.feature_ends.push_back(static_cast<std::uint32_t>(RegionView(result.regions).polygon_count()));
  }
  return result;
}

Layer with_rows(const Layer& layer, const RegionSet& regions) {
  Layer result;
  generators::append(result.regions, layer.regions);
  result.feature_ends = layer.feature_ends;
  append_rows(result, regions);
  return result;
}

Layer only_new_rows(const Layer& layer, const RegionSet& regions) {
  Layer result;
  result.feature_ends.assign(layer.feature_ends.size(), 0);
  append_rows(result, regions);
  return result;
}

std::vector<std::uint32_t> random_groups(const FeatureView& layer, std::uint32_t groups, std::uint64_t seed) {
  Random random(seed ^ 0x67726f757073);
  std::vector<std::uint32_t> result(layer.feature_count());
  for (std::uint32_t& group : result) group = static_cast<std::uint32_t>(random.below(static_cast<int>(groups)));
  return result;
}

}  // namespace oblast::testing
