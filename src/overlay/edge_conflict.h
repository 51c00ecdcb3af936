// What keeps an edge from taking the place of its pieces.
#pragma once

#include "exact/orientation.h"

namespace oblast {

/// Whether edges (a, b) and (c, d) meet in more than one end. REQUIRES: their boxes meet.
inline bool in_conflict(const Point& a, const Point& b, const Point& c, const Point& d) {
  using exact::orientation;
  const bool share_a = a == c || a == d, share_b = b == c || b == d;
  if (share_a && share_b) return true;
  const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
  if (share_a || share_b) {
    if (c_side != 0 || d_side != 0) return false;
    const Point &shared = share_a ? a : b, &p = share_a ? b : a, &q = (c == shared) ? d : c;
    return lexicographically_less(p, shared) == lexicographically_less(q, shared);
  }
  if (c_side * d_side > 0) return false;
  if (c_side == 0 && d_side == 0) return true;  // collinear with boxes that meet
  return orientation(c, d, a) * orientation(c, d, b) <= 0;
}

/// Tells whether a point lies inside a ring that comes edge by edge: an upward ray crosses it an odd number of times.
/// REQUIRES: it does not lie on the ring.
class PointInRing {
 public:
  explicit PointInRing(const Point& point) : point_(point) {}

  void add_edge(const Point& u, const Point& v) {
    if ((u.x <= point_.x) == (v.x <= point_.x)) return;
    inside_ ^= exact::orientation(u, v, point_) == (u.x < v.x ? -1 : 1);
  }
  bool is_inside() const { return inside_; }

 private:
  Point point_;
  bool inside_ = false;
};

}  // namespace oblast
