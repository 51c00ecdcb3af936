// Restoring the written order; see flatgeobuf_order.h.
#include "io/flatgeobuf_order.h"

#include <ogr_feature.h>

namespace oblast::io {

FlatgeobufOrder::FlatgeobufOrder(int field, Layer& layer)
    : field_(field),
      layer_(layer),
      first_polygon_(layer.regions.polygon_ends.size()),
      first_feature_(layer.features.size()) {}

void FlatgeobufOrder::add(const OGRFeature& feature) {
  if (field_ < 0) return;
  const std::size_t polygons = layer_.regions.polygon_ends.size() - first_polygon_;
  if (polygons != number_.size() + 1 || !feature.IsFieldSetAndNotNull(field_)) {
    field_ = -1;  // several polygons in a feature, or none: not a file of ours
    return;
  }
  number_.push_back(feature.GetFieldAsInteger64(field_));
}

bool FlatgeobufOrder::is_permutation() const {
  const auto count = static_cast<std::int64_t>(number_.size());
  std::vector<bool> seen(number_.size());
  for (const std::int64_t n : number_) {
    if (n < 0 || n >= count || seen[static_cast<std::size_t>(n)]) return false;
    seen[static_cast<std::size_t>(n)] = true;
  }
  return true;
}

void FlatgeobufOrder::restore() {
  if (field_ < 0 || number_.empty() || !is_permutation()) return;
  std::vector<std::size_t> source(number_.size());
  for (std::size_t i = 0; i < number_.size(); ++i) source[static_cast<std::size_t>(number_[i])] = i;

  const RegionSet old = layer_.regions;
  const RegionView view = old;
  const std::vector<FeatureRange> old_features(layer_.features.begin() + static_cast<std::ptrdiff_t>(first_feature_),
                                               layer_.features.end());
  RegionSet& out = layer_.regions;
  const std::uint32_t first_contour = first_polygon_ == 0 ? 0 : old.polygon_ends[first_polygon_ - 1];
  out.polygon_ends.resize(first_polygon_);
  out.contour_ends.resize(first_contour);
  out.points.resize(first_contour == 0 ? 0 : old.contour_ends[first_contour - 1]);
  for (std::size_t n = 0; n < source.size(); ++n) {
    const std::size_t from = first_polygon_ + source[n];
    for (std::size_t c = view.polygon_begin(from); c < view.polygon_end(from); ++c) {
      const auto contour = view.contour(c);
      out.points.insert(out.points.end(), contour.begin(), contour.end());
      out.contour_ends.push_back(static_cast<std::uint32_t>(out.points.size()));
    }
    out.polygon_ends.push_back(static_cast<std::uint32_t>(out.contour_ends.size()));
    FeatureRange feature = old_features[source[n]];
    feature.first_polygon = static_cast<std::uint32_t>(first_polygon_ + n);
    layer_.features[first_feature_ + n] = feature;
  }
}

}  // namespace oblast::io
