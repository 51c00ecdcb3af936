#include <oblast/measure.h>

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "check/coverage_areas.h"

namespace oblast::internal::checking {
namespace {

/// The areas of which a feature is a source.
class AreasOfFeatures {
 public:
  void add(std::uint32_t row, std::span<const FeatureSource> sources) {
    for (const FeatureSource& source : sources) areas_.emplace_back(source.feature, row);
  }
  void sort() { parallel_sort(areas_.begin(), areas_.end()); }

  /// Whether there is an area of both. REQUIRES: sort().
  bool have_common(std::uint32_t f, std::uint32_t g) const {
    auto i = std::lower_bound(areas_.begin(), areas_.end(), Area{f, 0});
    auto j = std::lower_bound(areas_.begin(), areas_.end(), Area{g, 0});
    while (i != areas_.end() && i->first == f && j != areas_.end() && j->first == g) {
      if (i->second == j->second) return true;
      i->second < j->second ? ++i : ++j;
    }
    return false;
  }

 private:
  using Area = std::pair<std::uint32_t, std::uint32_t>;
  Array<Area> areas_;
};

/// Finds, for a point of the border of an area, the two features that meet there.
class OverlapPlaces {
 public:
  OverlapPlaces(const LayerEdges& edges, const LayerContacts& contacts, std::span<const FeatureSource> sources)
      : edges_(edges), contacts_(contacts), sources_(sources) {}

  /// Of all points of the border the first at which both borders are known, else one of them.
  FeatureFault best(std::span<const Point> border) const {
    FeatureFault best{FeatureFaultKind::overlap, {sources_[0].feature}, {sources_[1].feature}, border[0]};
    int best_rank = 0;
    for (const Point& p : border) {
      const auto [rank, fault] = at(p);
      if (rank > best_rank) best = fault, best_rank = rank;
      if (best_rank == 3) break;
    }
    return best;
  }

 private:
  bool covers(std::uint32_t feature) const {
    return std::binary_search(sources_.begin(), sources_.end(), FeatureSource{0, feature});
  }

  /// 3: a crossing; 2: vertices of two features; 1: a vertex of one of them.
  std::pair<int, FeatureFault> at(const Point& p) const {
    for (const BorderCrossing& c : contacts_.crossings_at(p))
      if (covers(edges_.feature_of(c.i)) && covers(edges_.feature_of(c.j)))
        return {3, {FeatureFaultKind::overlap, edges_.place(c.i), edges_.place(c.j), p}};
    FeatureFault fault{FeatureFaultKind::overlap, {}, {}, p};
    int rank = 0;
    for (const std::uint32_t i : edges_.at(p)) {
      const FeaturePlace place = edges_.place(i);
      if (!covers(place.feature)) continue;
      if (rank == 0) fault.place = place, rank = 1;
      if (place.feature == fault.place.feature) continue;
      fault.other = place;
      return {2, fault};
    }
    if (rank == 1) fault.other = on_edge(p, fault.place.feature);
    return {rank == 1 && fault.other.vertex != FeaturePlace::none ? 2 : rank, fault};
  }

  /// The edge of another source on which a vertex at p lies, or just the other source.
  FeaturePlace on_edge(const Point& p, std::uint32_t feature) const {
    for (const std::uint32_t i : edges_.at(p)) {
      auto c = std::lower_bound(contacts_.on_edges.begin(), contacts_.on_edges.end(), VertexOnEdge{i, 0});
      for (; c != contacts_.on_edges.end() && c->vertex == i; ++c) {
        const FeaturePlace place = edges_.place(c->edge);
        if (place.feature != feature && covers(place.feature)) return place;
      }
    }
    return {sources_[sources_[0].feature == feature ? 1 : 0].feature};
  }

  const LayerEdges& edges_;
  const LayerContacts& contacts_;
  std::span<const FeatureSource> sources_;
};

}  // namespace

void add_overlaps(const FeatureView& features, const LayerEdges& edges, const LayerContacts& contacts,
                  std::vector<FeatureFault>& faults) {
  const Partition parts = partition({&features, 1});
  const RegionView regions = parts.rows.regions;
  AreasOfFeatures areas;
  for (std::size_t row = 0; row < parts.rows.size(); ++row) {
    const std::span<const FeatureSource> sources = parts.sources_of(row);
    if (sources.size() < 2) continue;
    if (!contacts.crossings.empty()) areas.add(static_cast<std::uint32_t>(row), sources);
    const OverlapPlaces places(edges, contacts, sources);
    const FeatureView view = parts.rows;
    for (std::uint32_t p = view.feature_begin(row); p < view.feature_end(row); ++p) {
      FeatureFault fault = places.best(regions.contour(regions.polygon_begin(p)));
      if (fault.other < fault.place) std::swap(fault.place, fault.other);
      fault.area = area(regions.polygon(p));
      faults.push_back(fault);
    }
  }
  areas.sort();
  // Crossings without an area: rounding closed it.
  for (const BorderCrossing& c : contacts.crossings) {
    const FeaturePlace place = edges.place(c.i), other = edges.place(c.j);
    if (areas.have_common(place.feature, other.feature)) continue;
    faults.push_back({FeatureFaultKind::overlap, std::min(place, other), std::max(place, other), c.point});
  }
}

}  // namespace oblast::internal::checking
