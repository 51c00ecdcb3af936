// Regions as flat arrays: what goes into an overlay and what comes out of it.
//
//   points         p0 p1 p2 p3 | p4 p5 p6 | p7 p8 p9 p10
//   contour_ends   4, 7, 11          contour c is points [contour_ends[c-1], contour_ends[c])
//   polygon_ends   2, 3              polygon p is contours [polygon_ends[p-1], polygon_ends[p])
//
// A contour is closed implicitly: its last point is joined to its first, which is not repeated
// (a repeated one is accepted on input). Indices are 32-bit.
#pragma once

#include <oblast/export.h>
#include <oblast/point.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace oblast {

/// A caller's arrays, viewed without copying them. Any closed contours are admitted: they may cross
/// themselves and each other, overlap, repeat, nest and touch. With `polygon_ends` empty every
/// contour is a polygon of its own.
struct RegionView {
  std::span<const Point> points;
  std::span<const std::uint32_t> contour_ends;
  std::span<const std::uint32_t> polygon_ends;

  std::size_t contour_count() const { return contour_ends.size(); }
  std::size_t polygon_count() const { return polygon_ends.empty() ? contour_ends.size() : polygon_ends.size(); }

  std::uint32_t contour_begin(std::size_t c) const { return c == 0 ? 0 : contour_ends[c - 1]; }
  std::uint32_t contour_end(std::size_t c) const { return contour_ends[c]; }
  std::span<const Point> contour(std::size_t c) const {
    return points.subspan(contour_begin(c), contour_end(c) - contour_begin(c));
  }

  std::uint32_t polygon_begin(std::size_t p) const {
    if (polygon_ends.empty()) return static_cast<std::uint32_t>(p);
    return p == 0 ? 0 : polygon_ends[p - 1];
  }
  std::uint32_t polygon_end(std::size_t p) const {
    return polygon_ends.empty() ? static_cast<std::uint32_t>(p + 1) : polygon_ends[p];
  }
};

/// Owned contours and polygons. As a result of an overlay it is canonical (promise G3): polygons do
/// not overlap; the first contour of each is its outer one, counter-clockwise; the others are its
/// holes, clockwise; each contour starts at its lexicographically smallest vertex.
struct RegionSet {
  std::vector<Point> points;
  std::vector<std::uint32_t> contour_ends;
  std::vector<std::uint32_t> polygon_ends;

  bool empty() const { return points.empty(); }
  operator RegionView() const { return {points, contour_ends, polygon_ends}; }
  RegionView view() const { return *this; }

  friend bool operator==(const RegionSet&, const RegionSet&) = default;
};

/// Signed area enclosed by the contours as they are directed (counter-clockwise is positive), in
/// squared units of the coordinates. For a result this is the area of its regions. Cost: linear. In doubles: off by at
/// most 2^-50 of the sum of |dx1 dy2| + |dx2 dy1| over the triangles of each contour's fan from its first vertex, so
/// the area of slivers alone can come out with either sign. Throws Error: not_finite, out_of_domain, too_large,
/// bad_offsets.
OBLAST_API double signed_area(const RegionView& regions);

}  // namespace oblast
