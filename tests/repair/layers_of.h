// Layers for tests of repair: features from WKT, and rows in canonical form.
#pragma once

#include <oblast/oblast.h>

#include <string>
#include <vector>

#include "verify/rows.h"

namespace oblast::testing {

struct TextLayer {
  RegionSet regions;
  std::vector<std::uint32_t> ends;

  /// A feature for each text.
  explicit TextLayer(const std::vector<std::string>& features) {
    for (const std::string& text : features) {
      const RegionSet part = read_wkt(text);
      const auto points = static_cast<std::uint32_t>(regions.points.size());
      const auto contours = static_cast<std::uint32_t>(regions.contour_ends.size());
      regions.points.insert(regions.points.end(), part.points.begin(), part.points.end());
      for (const std::uint32_t end : part.contour_ends) regions.contour_ends.push_back(points + end);
      for (const std::uint32_t end : part.polygon_ends) regions.polygon_ends.push_back(contours + end);
      ends.push_back(static_cast<std::uint32_t>(regions.polygon_ends.size()));
    }
  }
  operator FeatureView() const { return {regions, ends}; }
};

inline std::string text_of(const FeatureView& layer, std::size_t feature) {
  return to_wkt(verify::regions_of(layer, feature));
}

inline std::vector<std::string> texts_of(const FeatureView& layer) {
  std::vector<std::string> texts;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) texts.push_back(text_of(layer, f));
  return texts;
}

/// Each row in canonical form. Rows that an overlay would leave as they are keep their vertices.
inline FeatureSet canonical_rows(const FeatureView& layer) {
  FeatureSet rows;
  for (std::uint32_t f = 0; f < layer.feature_count(); ++f) {
    const RegionSet part = unite(verify::regions_of(layer, f));
    const auto points = static_cast<std::uint32_t>(rows.regions.points.size());
    const auto contours = static_cast<std::uint32_t>(rows.regions.contour_ends.size());
    rows.regions.points.insert(rows.regions.points.end(), part.points.begin(), part.points.end());
    for (const std::uint32_t end : part.contour_ends) rows.regions.contour_ends.push_back(points + end);
    for (const std::uint32_t end : part.polygon_ends) rows.regions.polygon_ends.push_back(contours + end);
    rows.feature_ends.push_back(static_cast<std::uint32_t>(rows.regions.polygon_ends.size()));
    rows.keys.push_back({f, no_feature});
  }
  return rows;
}

}  // namespace oblast::testing
