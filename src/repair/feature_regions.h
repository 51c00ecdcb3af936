// One feature of a layer.
#pragma once

#include <oblast/features.h>

namespace oblast::internal::repairing {

/// A view of its polygons.
inline RegionView feature_regions(const FeatureView& layer, std::size_t feature) {
  const std::uint32_t begin = layer.feature_begin(feature), end = layer.feature_end(feature);
  if (begin == end) return {};
  const RegionView& all = layer.regions;
  const std::uint32_t first_contour = all.polygon_begin(begin);
  RegionView alone = all.contours_between(first_contour, all.polygon_end(end - 1));
  if (all.polygon_ends.empty()) return alone;
  alone.polygon_ends = all.polygon_ends.subspan(begin, end - begin);
  alone.first_contour = all.first_contour + first_contour;
  return alone;
}

}  // namespace oblast::internal::repairing
