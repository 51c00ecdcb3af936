// Points that the rings of a feature go through more than once, at vertices.
#pragma once

#include <cstdint>
#include <functional>

#include "check/feature_rings.h"

namespace oblast::internal::checking {

enum class VertexMeeting {
  touch,  ///< both keep to one side of the other
  cross,  ///< one goes over to the other side
};

/// Calls found(meeting, i, j) for vertices i > j at one point: for each vertex the first one before it that it crosses
/// there, or else one of its own ring that it touches, and one of each other ring. Vertices of edges that run along
/// each other are passed over. Cost: O(n log n + m^2), m vertices at one point.
void for_common_vertices(const FeatureRings& rings,
                         const std::function<void(VertexMeeting, std::uint32_t, std::uint32_t)>& found);

}  // namespace oblast::internal::checking
