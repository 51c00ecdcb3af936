// Which rows of a coverage share a border.
#pragma once

#include <oblast/features.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace oblast::io {

/// Pairs of rows (smaller, larger) that have an edge in common, ascending, each once. Edges are the same if their ends
/// are, bit for bit, as in results of overlays (promise G8). Cost: O(n log n).
std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours_of(const FeatureView& rows);

}  // namespace oblast::io
