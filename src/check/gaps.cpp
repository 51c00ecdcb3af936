#include <oblast/domain.h>
#include <oblast/measure.h>
#include <oblast/overlay.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "check/coverage_areas.h"

namespace oblast::internal::checking {
namespace {

/// The vertices of a feature between which an edge p q runs, in either direction.
template <class Found>
void for_owners(const LayerEdges& edges, const Point& p, const Point& q, const Found& found) {
  for (const std::uint32_t i : edges.at(p)) {
    const Point &before = edges.points()[edges.before(i)], &after = edges.points()[i + 1];
    if (before == q || after == q) found(i);
  }
}

bool owns(const LayerEdges& edges, std::uint32_t feature, const Point& p, const Point& q) {
  bool result = false;
  for_owners(edges, p, q, [&](std::uint32_t i) { result |= edges.feature_of(i) == feature; });
  return result;
}

/// Whether one feature has all edges of the contour, so that the hole is its own.
bool is_of_one_feature(const LayerEdges& edges, std::span<const Point> contour) {
  bool result = false;
  for_owners(edges, contour[0], contour[1], [&](std::uint32_t i) {
    const std::uint32_t feature = edges.feature_of(i);
    bool all = !result;
    for (std::size_t v = 1; all && v < contour.size(); ++v)
      all = owns(edges, feature, contour[v], contour[v + 1 < contour.size() ? v + 1 : 0]);
    result |= all;
  });
  return result;
}

/// At the first vertex at which two features meet; without another feature if there is no such vertex.
FeatureFault fault_of(const LayerEdges& edges, const LayerContacts& contacts, std::span<const Point> contour) {
  for (const Point& p : contour) {
    FeaturePlace first, second;
    const auto add = [&](std::uint32_t index) {
      const FeaturePlace place = edges.place(index);
      if (first.feature == FeaturePlace::none) {
        first = place;
      } else if (place.feature != first.feature && second.feature == FeaturePlace::none) {
        second = place;
      }
    };
    for (const std::uint32_t i : edges.at(p)) add(i);
    for (const BorderCrossing& c : contacts.crossings_at(p)) add(c.i), add(c.j);
    for (const std::uint32_t i : edges.at(p)) {
      auto c = std::lower_bound(contacts.on_edges.begin(), contacts.on_edges.end(), VertexOnEdge{i, 0});
      for (; c != contacts.on_edges.end() && c->vertex == i; ++c) add(c->edge);
    }
    if (second.feature != FeaturePlace::none) return {FeatureFaultKind::gap, first, second, p};
  }
  return {FeatureFaultKind::gap, {}, {}, contour[0]};
}

/// A box well around all points.
RegionSet frame_around(std::span<const Point> points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const double side = std::min(4 * largest, domain_largest);
  return {{{-side, -side}, {side, -side}, {side, side}, {-side, side}}, {4}, {1}};
}

/// Whether an area that nobody covers is the one around everything.
bool is_outside(std::span<const Point> contour, const RegionSet& frame) {
  const double side = frame.points[2].x;
  return std::any_of(contour.begin(), contour.end(),
                     [&](const Point& p) { return std::abs(p.x) == side || std::abs(p.y) == side; });
}

}  // namespace

void add_gaps(const FeatureView& features, const LayerEdges& edges, const LayerContacts& contacts,
              std::vector<FeatureFault>& faults) {
  if (edges.strands().size() == 0) return;
  const RegionSet frame = frame_around(features.regions.points);
  const RegionSet uncovered = overlay(frame, features.regions, Operation::difference);
  const RegionView regions = uncovered;
  Steps steps(regions.polygon_count());
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    steps();
    const std::span<const Point> contour = regions.contour(regions.polygon_begin(p));
    if (is_outside(contour, frame) || is_of_one_feature(edges, contour)) continue;
    FeatureFault fault = fault_of(edges, contacts, contour);
    if (fault.other.feature == FeaturePlace::none) continue;  // of one feature whose rings cross
    fault.area = area(regions.polygon(p));
    faults.push_back(fault);
  }
}

}  // namespace oblast::internal::checking
