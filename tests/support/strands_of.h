// Strands written as lists of points, for tests of single stages.
#pragma once

#include <vector>

#include "noding/strands.h"

namespace oblast::testing {
using namespace internal;

using Path = std::vector<Point>;

/// One strand a path, flags 0 but for closed_flag at the ends of closed ones, every one of `group`.
noding::Strands strands_of(const std::vector<Path>& paths, noding::Winding change = {1, 0},
                           noding::Group group = noding::any_group);

/// Edges of all strands by their first vertex.
std::vector<std::uint32_t> edges_of(const noding::Strands& strands);

/// The first point repeated as the last.
Path closed(Path ring);

/// The corners of a box, counter-clockwise, not closed.
Path box(double x0, double y0, double x1, double y1);

}  // namespace oblast::testing
