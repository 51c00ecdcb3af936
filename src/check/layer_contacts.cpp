#include "check/layer_contacts.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <tuple>

#include "base/parallel.h"
#include "check/edge_pair.h"
#include "noding/edge_pairs.h"
#include "noding/monotone_runs.h"
#include "noding/pair_finder.h"

namespace oblast::internal::checking {
namespace {

bool before(const BorderCrossing& a, const BorderCrossing& b) {
  return std::tie(a.point.x, a.point.y, a.i, a.j) < std::tie(b.point.x, b.point.y, b.i, b.j);
}

template <class Items, class Less>
void sort_and_join(Items& items, const Less& less) {
  parallel_sort(items.begin(), items.end(), less);
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Whether the border goes on along the edge on both sides of the vertex.
bool goes_along(const LayerEdges& edges, const VertexOnEdge& c) {
  const Point &a = edges.points()[c.edge], &b = edges.points()[c.edge + 1];
  const Point &u = edges.points()[edges.before(c.vertex)], &v = edges.points()[c.vertex + 1];
  return exact::orientation(a, b, u) == 0 && exact::orientation(a, b, v) == 0;
}

}  // namespace

std::span<const BorderCrossing> LayerContacts::crossings_at(const Point& p) const {
  const auto first = std::partition_point(crossings.begin(), crossings.end(),
                                          [&](const BorderCrossing& c) { return lexicographically_less(c.point, p); });
  const auto past = std::partition_point(first, crossings.end(), [&](const BorderCrossing& c) { return c.point == p; });
  return {first, past};
}

LayerContacts find_contacts(const LayerEdges& edges) {
  LayerContacts contacts;
  std::mutex mutex;
  const Point* const points = edges.points();
  const auto visit = [&](std::span<const noding::RunPair> pairs) {
    poll();
    Array<BorderCrossing> crossings;
    Array<VertexOnEdge> on_edges;
    for (const noding::RunPair& pair : pairs) {
      noding::for_edge_pairs(points, pair, [&](std::uint32_t i, std::uint32_t j) {
        for_contacts(points, std::min(i, j), std::max(i, j),
                     [&](EdgeContact contact, std::uint32_t p, std::uint32_t q, const Point& at) {
                       if (edges.feature_of(p) == edges.feature_of(q)) return;
                       if (contact == EdgeContact::cross) crossings.push_back({at, p, q});
                       if (contact == EdgeContact::vertex_on_edge) on_edges.push_back({p, q});
                     });
      });
    }
    if (crossings.empty() && on_edges.empty()) return;
    const std::lock_guard lock(mutex);
    contacts.crossings.insert(contacts.crossings.end(), crossings.begin(), crossings.end());
    contacts.on_edges.insert(contacts.on_edges.end(), on_edges.begin(), on_edges.end());
  };
  noding::find_pairs(edges.strands().points, noding::monotone_runs(edges.strands(), noding::Grouping::by_strand),
                     std::ref(visit));
  sort_and_join(contacts.crossings, before);
  sort_and_join(contacts.on_edges, std::less<>());
  return contacts;
}

void add_junctions(const LayerEdges& edges, const LayerContacts& contacts, std::vector<FeatureFault>& faults) {
  // By point, pair of features, and places.
  struct Junction {
    FeatureFault fault;
    auto key() const {
      return std::tie(fault.point.x, fault.point.y, fault.place.feature, fault.other.feature, fault.place, fault.other);
    }
  };
  std::vector<Junction> junctions;
  junctions.reserve(contacts.on_edges.size());
  for (const VertexOnEdge& c : contacts.on_edges)
    junctions.push_back({{goes_along(edges, c) ? FeatureFaultKind::mismatched_vertices : FeatureFaultKind::t_junction,
                          edges.place(c.vertex), edges.place(c.edge), edges.points()[c.vertex]}});
  parallel_sort(junctions.begin(), junctions.end(),
                [](const Junction& a, const Junction& b) { return a.key() < b.key(); });
  const auto same = [](const FeatureFault& a, const FeatureFault& b) {
    return a.point == b.point && a.place.feature == b.place.feature && a.other.feature == b.other.feature;
  };
  for (std::size_t i = 0; i < junctions.size(); ++i)
    if (i == 0 || !same(junctions[i - 1].fault, junctions[i].fault)) faults.push_back(junctions[i].fault);
}

}  // namespace oblast::internal::checking
