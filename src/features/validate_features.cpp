#include "features/validate_features.h"

#include <oblast/error.h>

#include <algorithm>
#include <string>

#include "regions/validate.h"

namespace oblast::internal {
namespace {

/// Throws Error(bad_offsets).
void check_feature_ends(const FeatureView& layer, std::size_t operand) {
  if (layer.feature_ends.empty()) return;
  const std::size_t polygons = layer.regions.polygon_count();
  std::uint32_t before = 0;
  for (std::size_t f = 0; f < layer.feature_ends.size(); ++f) {
    const std::uint32_t end = layer.feature_ends[f];
    if (end < before || end > polygons)
      throw Error(ErrorCode::bad_offsets,
                  "feature_ends[" + std::to_string(f) + "] is " + std::to_string(end) + "; it must be " +
                      std::to_string(before) + " to " + std::to_string(polygons),
                  {operand});
    before = end;
  }
  if (before != polygons)
    throw Error(ErrorCode::bad_offsets,
                "the last of feature_ends is " + std::to_string(before) + "; there are " + std::to_string(polygons) +
                    " polygons",
                {operand});
}

/// REQUIRES: the ends of the features are right.
std::size_t feature_of(const FeatureView& layer, std::size_t polygon) {
  if (layer.feature_ends.empty()) return polygon;
  const auto after = std::upper_bound(layer.feature_ends.begin(), layer.feature_ends.end(), polygon);
  return static_cast<std::size_t>(after - layer.feature_ends.begin());
}

}  // namespace

void validate_features(const FeatureView& layer, std::size_t operand) {
  try {
    validate(layer.regions, operand);
  } catch (const Error& error) {
    if (error.place().polygon == Place::npos) throw;
    check_feature_ends(layer, operand);
    Place place = error.place();
    place.feature = feature_of(layer, place.polygon);
    throw Error(error.code(), error.what(), place);
  }
  check_feature_ends(layer, operand);
}

}  // namespace oblast::internal
