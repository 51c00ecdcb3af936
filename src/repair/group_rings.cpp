// Which rings are holes of which, where the rings of a polygon have no roles.
#include <oblast/repair.h>

#include <algorithm>

#include "base/parallel.h"
#include "base/public_call.h"
#include "features/validate_features.h"
#include "overlay/pipeline.h"
#include "regions/join_features.h"
#include "repair/append_regions.h"
#include "repair/feature_regions.h"
#include "repair/ordered_ring.h"

namespace oblast {
using namespace internal;
using namespace internal::repairing;
namespace {

/// A ring of the heap, counter-clockwise, and which one it is.
struct NumberedRing {
  Ring ring;
  std::uint32_t number;
};

/// The rings of each polygon, by their numbers: the outer one, then its holes. Polygons are in the order of their outer
/// rings, and holes in that of the heap.
using Groups = Array<Array<std::uint32_t>>;

/// The numbers of the rings that the resolved region has; no groups if the heap does not have the same rings.
Groups groups_of(const RegionView& heap, const RegionView& resolved) {
  if (heap.contour_count() != resolved.contour_count()) return {};
  Array<NumberedRing> rings;
  for (std::uint32_t c = 0; c < heap.contour_count(); ++c) {
    rings.push_back({ring_in_order(heap.contour(c), false), c});
    if (rings.back().ring.empty()) return {};
  }
  const auto before = [](const NumberedRing& p, const NumberedRing& q) { return comes_before(p.ring, q.ring); };
  std::sort(rings.begin(), rings.end(), before);
  Groups groups;
  for (const PolygonView polygon : resolved.polygons()) {
    Array<std::uint32_t>& group = groups.emplace_back();
    for (const std::span<const Point> contour : polygon.contours()) {
      const NumberedRing sought{ring_in_order(contour, false), 0};
      const auto found = std::lower_bound(rings.begin(), rings.end(), sought, before);
      if (found == rings.end() || !is_same_ring(found->ring, sought.ring, MoreVertices::allowed)) return {};
      group.push_back(found->number);
    }
    std::sort(group.begin() + 1, group.end());
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

void append_polygon(const RegionView& heap, const Array<std::uint32_t>& group, RegionSet& regions) {
  for (const std::uint32_t c : group) {
    const std::span<const Point> ring = heap.contour(c);
    regions.points.insert(regions.points.end(), ring.begin(), ring.end());
    regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
  }
  regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
}

RegionSet grouped(const RegionView& feature, Control& control) {
  RegionSet regions;
  for (const PolygonView heap : feature.polygons()) {
    Groups groups;
    if (heap.contour_count() > 1) {
      const Options options;
      Statistics statistics;
      const PipelineResult resolved = run_pipeline(heap, nullptr, {Operation::unite, options, control}, statistics);
      groups = groups_of(heap, resolved.regions);
    }
    if (groups.empty()) append_regions(heap, regions);
    for (const Array<std::uint32_t>& group : groups) append_polygon(heap, group, regions);
  }
  return regions;
}

}  // namespace

FeatureSet group_rings(const FeatureView& features, std::span<const std::uint32_t> without_roles,
                       const CallOptions& options) {
  const std::size_t count = features.feature_count();
  if (!std::is_sorted(without_roles.begin(), without_roles.end()) ||
      (!without_roles.empty() && without_roles.back() >= count))
    throw Error(ErrorCode::bad_option, "the features without roles must be features, in ascending order");
  return public_call(options, features.regions.points.size(), [&](Control& control) {
    validate_features(features, 0);
    Array<RegionSet> own(without_roles.size());
    for_ranges(own.size(), grain(own.size(), features.regions.points.size()), [&](std::size_t i, std::size_t end) {
      for (; i < end; ++i) own[i] = grouped(feature_regions(features, without_roles[i]), control);
    });
    Array<RegionView> parts;
    for (std::size_t f = 0; f < count; ++f) parts.push_back(feature_regions(features, f));
    for (std::size_t i = 0; i < own.size(); ++i) parts[without_roles[i]] = own[i];
    return join_features(parts).features;
  });
}

}  // namespace oblast
