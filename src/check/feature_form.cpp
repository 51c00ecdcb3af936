#include "check/feature_form.h"

#include <oblast/error.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "base/parallel.h"
#include "regions/validate.h"

namespace oblast {

const char* name(FeatureFaultKind kind) {
  constexpr const char* names[feature_fault_kinds] = {"ring not closed",
                                                      "too few points",
                                                      "spike",
                                                      "ring crosses itself",
                                                      "ring touches itself",
                                                      "ring runs along itself",
                                                      "repeated ring",
                                                      "hole crosses shell",
                                                      "hole outside its shell",
                                                      "holes overlap",
                                                      "rings share an edge",
                                                      "interior cut in two",
                                                      "parts overlap",
                                                      "parts share an edge",
                                                      "repeated vertex",
                                                      "wrong orientation",
                                                      "overlap",
                                                      "gap",
                                                      "T-junction",
                                                      "mismatched vertices"};
  const auto i = static_cast<std::size_t>(kind);
  return i < feature_fault_kinds ? names[i] : "";
}

namespace internal::checking {

void validate_features(const FeatureView& features) {
  validate(features.regions, 0);
  const std::size_t polygons = features.regions.polygon_count();
  std::uint32_t before = 0;
  for (std::size_t f = 0; f < features.feature_ends.size(); ++f) {
    const std::uint32_t end = features.feature_ends[f];
    if (end < before || end > polygons)
      throw Error(ErrorCode::bad_offsets, "feature_ends[" + std::to_string(f) + "] is " + std::to_string(end) +
                                              "; it must be " + std::to_string(before) + " to " +
                                              std::to_string(polygons));
    before = end;
  }
  if (!features.feature_ends.empty() && before != polygons)
    throw Error(ErrorCode::bad_offsets, "the last of feature_ends is " + std::to_string(before) + "; there are " +
                                            std::to_string(polygons) + " polygons");
}

void add_open_contours(const FeatureView& features, std::span<const std::uint32_t> contours,
                       std::vector<FeatureFault>& faults) {
  const RegionView& regions = features.regions;
  std::uint32_t feature = 0, polygon = 0;
  for (const std::uint32_t c : contours) {
    if (c >= regions.contour_count())
      throw Error(ErrorCode::bad_option, "open_contours has " + std::to_string(c) + "; there are " +
                                             std::to_string(regions.contour_count()) + " contours");
    while (polygon < regions.polygon_count() && regions.polygon_end(polygon) <= c) ++polygon;
    while (feature < features.feature_count() && features.feature_end(feature) <= polygon) ++feature;
    const std::span<const Point> contour = regions.contour(c);
    const auto last = static_cast<std::uint32_t>(contour.empty() ? 0 : contour.size() - 1);
    faults.push_back({FeatureFaultKind::ring_not_closed,
                      {feature, c, last},
                      {feature, c, 0},
                      contour.empty() ? Point{} : contour.back()});
  }
}

void put_in_order(std::vector<FeatureFault>& faults) {
  const auto key = [](const FeatureFault& f) {
    return std::tie(f.place, f.kind, f.other, f.point.x, f.point.y, f.area);
  };
  parallel_sort(faults.begin(), faults.end(),
                [&](const FeatureFault& a, const FeatureFault& b) { return key(a) < key(b); });
}

}  // namespace internal::checking
}  // namespace oblast
