// The largest counts of elements that have an index. Indices are 32-bit inside.
//
// A megabyte of input can have 2^32 crossings, so each count that can grow like this is checked (base/index.h). In test
// builds the limits are a million or two, so that tests can reach them.
#pragma once

#include <cstddef>

#include "base/tuning_setting.h"

namespace oblast::internal {

inline constexpr bool low_index_limits = tuning::setting != tuning::Setting::usual;

/// Vertices of both operands of a call together, and of a result, which may be an operand of the next call.
inline constexpr std::size_t most_vertices = low_index_limits ? std::size_t{3} << 19 : 0x7fffffff;

/// All other elements. Larger indices are marks, such as `none`, and room for loops that prefetch ahead.
inline constexpr std::size_t most_indices = low_index_limits ? std::size_t{1} << 21 : 0xffff0000;

/// Chains of the graph. A descriptor is the index of a chain, shifted by one bit.
inline constexpr std::size_t most_chains = most_indices / 2;

/// Vertices of a triangulation. There are twice as many triangles, and a half-edge is a triangle's index, shifted by
/// two bits.
inline constexpr std::size_t most_mesh_vertices = low_index_limits ? std::size_t{5} << 18 : std::size_t{1} << 29;

}  // namespace oblast::internal
