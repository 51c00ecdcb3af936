// Distances that rounding cannot bridge. classics/clearance.h has the proof.
#pragma once

#include <oblast/point.h>

namespace oblast::internal {

/// The distance that everything must keep from rounded points, for coordinates up to `largest` in magnitude.
constexpr double clearance_gap(double largest) { return largest * 0x1p-46; }

/// True if the distance of p from the segment (a, b) is more than `gap`. Computed in floating point: the error is about
/// 2^-50 of the largest coordinate, for which the gap has room. If a product overflows or underflows, the result is
/// false.
inline bool is_far(const Point& p, const Point& a, const Point& b, double gap) {
  const double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y, qx = p.x - b.x, qy = p.y - b.y;
  const double square = dx * dx + dy * dy;
  if (square <= gap * gap) return px * px + py * py > 16 * (gap * gap);
  if (px * dx + py * dy <= 0) return px * px + py * py > gap * gap;
  if (qx * dx + qy * dy >= 0) return qx * qx + qy * qy > gap * gap;
  const double cross = dx * py - dy * px;
  return cross * cross > gap * gap * square;
}

}  // namespace oblast::internal
