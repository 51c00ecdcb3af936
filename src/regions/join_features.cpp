#include "regions/join_features.h"

#include <algorithm>

#include "base/index.h"
#include "base/parallel.h"

namespace oblast::internal {
namespace {

/// Where the arrays of a feature begin in those of the layer.
struct Offsets {
  std::size_t points = 0, contours = 0, polygons = 0;
};

void copy(const RegionView& part, const Offsets& at, RegionSet& to) {
  std::copy(part.points.begin(), part.points.end(), to.points.begin() + static_cast<std::ptrdiff_t>(at.points));
  for (std::size_t c = 0; c < part.contour_count(); ++c)
    to.contour_ends[at.contours + c] = static_cast<std::uint32_t>(at.points + part.contour_end(c));
  for (std::size_t p = 0; p < part.polygon_count(); ++p)
    to.polygon_ends[at.polygons + p] = static_cast<std::uint32_t>(at.contours + part.polygon_end(p));
}

}  // namespace

JoinedFeatures join_features(const Array<RegionView>& parts) {
  Array<Offsets> offsets;
  Offsets end;
  for (const RegionView& part : parts) {
    offsets.push_back(end);
    end.points += part.points.size();
    end.contours += part.contour_count();
    end.polygons += part.polygon_count();
  }
  check_count(end.points, "vertices of a result", most_vertices);
  check_count(end.contours, "contours of a result");
  check_count(end.polygons, "polygons of a result");
  JoinedFeatures joined{{}, Charge(bytes_of_regions(end.points, end.contours, end.polygons))};
  RegionSet& regions = joined.features.regions;
  regions.points.resize(end.points);
  regions.contour_ends.resize(end.contours);
  regions.polygon_ends.resize(end.polygons);
  for_ranges(parts.size(), grain(parts.size(), end.points), [&](std::size_t f, std::size_t past) {
    for (; f < past; ++f) copy(parts[f], offsets[f], regions);
  });
  for (std::uint32_t f = 0; f < parts.size(); ++f) {
    const std::size_t polygons = offsets[f].polygons + parts[f].polygon_count();
    joined.features.feature_ends.push_back(static_cast<std::uint32_t>(polygons));
    joined.features.keys.push_back({f, no_feature});
  }
  return joined;
}

}  // namespace oblast::internal
