// How many there may be of what has an index: indices are 32-bit inside.
//
// A megabyte of input can have 2^32 crossings, so each count that can grow so is checked (base/index.h). In test builds
// the limits are a million or two, so that tests come to them.
#pragma once

#include <cstddef>

#include "base/tuning_setting.h"

namespace oblast::internal {

inline constexpr bool low_index_limits = tuning::setting != tuning::Setting::usual;

/// Vertices of both operands of a call together, and of a result, which may be an operand of the next call.
inline constexpr std::size_t most_vertices = low_index_limits ? std::size_t{3} << 19 : 0x7fffffff;

/// All else. The indices above it are marks, as `none`, and room for loops that look some way ahead.
inline constexpr std::size_t most_indices = low_index_limits ? std::size_t{1} << 21 : 0xffff0000;

/// Chains of the graph: a descriptor is a chain's index, shifted by one.
inline constexpr std::size_t most_chains = most_indices / 2;

/// Vertices of a triangulation: they have twice as many triangles, and a half-edge is one's index, shifted by two.
inline constexpr std::size_t most_mesh_vertices = low_index_limits ? std::size_t{5} << 18 : std::size_t{1} << 29;

}  // namespace oblast::internal
