// The Voronoi diagram of a few points in a box, by exact rational numbers and brute force.
#pragma once

#include <oblast/features.h>

#include <optional>
#include <span>
#include <vector>

#include "verify/box_tree.h"
#include "verify/rational.h"
#include "verify/verify.h"

namespace oblast::verify {

/// The cell of each point within the box, counter-clockwise. Empty if it has no area: of equal points the first has the
/// cell. Cost: O(n^2 k) rational operations, k vertices of a cell.
std::vector<std::vector<RationalPoint>> voronoi_cells(std::span<const Point> points, const Box& box);

/// Whether row i is the cell of point i with its vertices rounded: those within the box bit for bit; those on its
/// boundary, and those that are so near to another vertex of a cell, within `tolerance`. Further vertices of the row
/// must be as near to edges of the cell.
std::optional<Fault> check_voronoi(std::span<const Point> points, const Box& box, const FeatureView& rows,
                                   double tolerance);

}  // namespace oblast::verify
