// The edges of all contours, as what locates points reads them.
#pragma once

#include <oblast/region_set.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace oblast::internal::locate {

using Index = std::uint32_t;

/// Closed rings, one after another: edge i runs from points[i] to points[i + 1], where both are of one ring.
struct Edges {
  std::vector<Point> points;
  std::vector<Index> edges;  ///< by where they begin; none of no length

  const Point& from(Index edge) const { return points[edge]; }
  const Point& to(Index edge) const { return points[edge + 1]; }
  /// The end with the smaller y, and the other one.
  const Point& lower(Index edge) const { return from(edge).y <= to(edge).y ? from(edge) : to(edge); }
  const Point& upper(Index edge) const { return from(edge).y <= to(edge).y ? to(edge) : from(edge); }

  /// Of the edges of these regions, at most.
  static std::size_t bytes(const RegionView& regions) {
    return (regions.points.size() + regions.contour_count()) * (sizeof(Point) + sizeof(Index));
  }
};

/// The edges of all contours, with 0.0 in place of -0.0. Throws Error(too_large).
Edges edges_of(const RegionView& regions);

}  // namespace oblast::internal::locate
