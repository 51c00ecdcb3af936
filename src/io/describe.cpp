// From indices of the arrays back to files and features.
#include <fmt/format.h>

#include <algorithm>

#include "io/layer.h"

namespace oblast::io {

std::string describe(const Layer& layer, const Place& place) {
  const RegionView regions = layer.regions;
  std::size_t polygon = place.polygon;
  if (polygon == Place::npos && place.contour != Place::npos) {
    polygon = regions.polygon_ends.empty()
                  ? place.contour
                  : std::upper_bound(regions.polygon_ends.begin(), regions.polygon_ends.end(), place.contour) -
                        regions.polygon_ends.begin();
  }
  if (polygon == Place::npos || polygon >= regions.polygon_count()) {
    return layer.files.size() == 1 ? layer.files.front() : fmt::format("{} files", layer.files.size());
  }

  std::string text;
  std::size_t first_polygon = 0;
  const auto after = std::upper_bound(layer.features.begin(), layer.features.end(), polygon,
                                      [](std::size_t p, const FeatureRange& f) { return p < f.first_polygon; });
  if (after != layer.features.begin()) {
    const FeatureRange& feature = *(after - 1);
    first_polygon = feature.first_polygon;
    text = fmt::format("{}, feature {}, ", layer.files.at(feature.file), feature.feature);
  }
  text += fmt::format("part {}", polygon - first_polygon + 1);
  if (place.contour != Place::npos) {
    text += fmt::format(", ring {}", place.contour - regions.polygon_begin(polygon) + 1);
    if (place.vertex != Place::npos) text += fmt::format(", vertex {}", place.vertex);
  }
  return text;
}

}  // namespace oblast::io
