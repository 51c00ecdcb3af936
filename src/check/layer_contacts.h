// Where borders of different features meet other than in common vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/call_memory.h"
#include "check/layer_edges.h"

namespace oblast::internal::checking {

/// Two borders cross inside an edge of each.
struct BorderCrossing {
  Point point;  ///< the nearest double
  std::uint32_t i, j;

  friend bool operator==(const BorderCrossing&, const BorderCrossing&) = default;
};

/// A vertex lies inside an edge of another feature.
struct VertexOnEdge {
  std::uint32_t vertex, edge;

  friend auto operator<=>(const VertexOnEdge&, const VertexOnEdge&) = default;
};

struct LayerContacts {
  Array<BorderCrossing> crossings;  ///< by point, then by edges
  Array<VertexOnEdge> on_edges;     ///< ascending

  std::span<const BorderCrossing> crossings_at(const Point& p) const;
};

/// Exact. Cost: O((n + k) log n), k pairs of edges that meet, on all cores.
LayerContacts find_contacts(const LayerEdges& edges);

/// Adds T-junctions and mismatched vertices: one fault for each point and pair of features.
void add_junctions(const LayerEdges& edges, const LayerContacts& contacts, std::vector<FeatureFault>& faults);

}  // namespace oblast::internal::checking
