// Walks around lines.
#pragma once

#include <oblast/buffer.h>

#include "base/call_memory.h"
#include "buffer/pockets.h"
#include "buffer/walk.h"

namespace oblast::internal::buffering {

/// The line without points that repeat the one before, turned so that equal lines in opposite directions are one
/// (unless its direction matters, for one side).
Array<Point> line_path(std::span<const Point> line, Side side);

/// The walks around a path, or along its one side. Pockets up to `widest_lid` are closed. Adds to `pockets`.
/// REQUIRES: at least two points, no two neighbours equal.
Array<Walk> line_walks(const Array<Point>& path, Side side, Cap cap, double widest_lid, std::uint64_t& pockets);

}  // namespace oblast::internal::buffering
