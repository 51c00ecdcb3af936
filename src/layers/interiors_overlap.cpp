// Whether the interiors of two simple contours overlap.
#include "layers/interiors_overlap.h"

#include "exact/orientation.h"

namespace oblast::internal {
namespace {

using exact::orientation;

/// The interior of a contour near a point x of its boundary: from one direction counter-clockwise to another.
struct Sector {
  Point from, to;
};

bool same_direction(const Point& x, const Point& p, const Point& q) {
  return orientation(x, p, q) == 0 && lexicographically_less(x, p) == lexicographically_less(x, q);
}

/// True if the direction from x to p is strictly inside the sector.
bool strictly_inside(const Point& x, const Sector& s, const Point& p) {
  const int opening = orientation(x, s.from, s.to);
  if (opening > 0) return orientation(x, s.from, p) > 0 && orientation(x, p, s.to) > 0;
  if (opening == 0) return orientation(x, s.from, p) > 0;
  return !(orientation(x, s.to, p) >= 0 && orientation(x, p, s.from) >= 0);
}

bool sectors_overlap(const Point& x, const Sector& s, const Sector& t) {
  return same_direction(x, s.from, t.from) || strictly_inside(x, s, t.from) || strictly_inside(x, t, s.from);
}

Sector sector_at(const ContourTree& contour, std::uint32_t edge, const Point& x) {
  const Point &a = contour.ring[edge], &b = contour.next(edge);
  const Point& before = x == a ? contour.previous(edge) : a;
  const Point& after = x == b ? contour.next(edge + 1 == contour.ring.size() ? 0 : edge + 1) : b;
  return contour.shape == RingShape::counter_clockwise ? Sector{after, before} : Sector{before, after};
}

}  // namespace

bool InteriorTest::overlap(const ContourTree& p, const ContourTree& q) {
  if (p.shape == RingShape::tangled || q.shape == RingShape::tangled) return true;
  switch (boundaries(p, q)) {
    case Meeting::overlap:
      return true;
    case Meeting::touch:
      return false;
    case Meeting::apart:
      break;
  }
  return inside(p.ring[0], q) || inside(q.ring[0], p);
}

InteriorTest::Meeting InteriorTest::boundaries(const ContourTree& p, const ContourTree& q) {
  Meeting met = Meeting::apart;
  const auto touch_at = [&](const Point& x, std::uint32_t i, std::uint32_t j) {
    met = sectors_overlap(x, sector_at(p, i, x), sector_at(q, j, x)) ? Meeting::overlap : Meeting::touch;
  };
  //        d
  //   a ---+--- b     edge i of p;  c, d: ends of edge j of q
  //        c
  const auto compare_edges = [&](std::uint32_t i, std::uint32_t j) {
    const Point &a = p.ring[i], &b = p.next(i), &c = q.ring[j], &d = q.next(j);
    const Box ab = Box::of(a, b), cd = Box::of(c, d);
    if (!ab.meets(cd)) return;
    const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
    if (c_side * d_side > 0) return;
    const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
    if (a_side * b_side > 0) return;
    if (c_side != 0 && d_side != 0 && a_side != 0 && b_side != 0) {
      met = Meeting::overlap;
      return;
    }
    const auto holds = [](const Box& box, const Point& x) { return box.meets(Box::of(x, x)); };
    if (c_side == 0 && holds(ab, c)) touch_at(c, i, j);
    if (met != Meeting::overlap && d_side == 0 && holds(ab, d)) touch_at(d, i, j);
    if (met != Meeting::overlap && a_side == 0 && holds(cd, a)) touch_at(a, i, j);
    if (met != Meeting::overlap && b_side == 0 && holds(cd, b)) touch_at(b, i, j);
  };

  pairs_.assign(1, {1, 1});
  while (!pairs_.empty()) {
    const auto [m, n] = pairs_.back();
    pairs_.pop_back();
    if (!p.box_of(m).meets(q.box_of(n))) continue;
    if (p.is_leaf(m) && q.is_leaf(n)) {
      for (std::uint32_t i = p.first_edge(m); i < p.last_edge(m); ++i) {
        for (std::uint32_t j = q.first_edge(n); j < q.last_edge(n); ++j) {
          compare_edges(i, j);
          if (met == Meeting::overlap) return met;
        }
      }
    } else if (!p.is_leaf(m) && (q.is_leaf(n) || m <= n)) {
      pairs_.push_back({2 * m, n});
      pairs_.push_back({2 * m + 1, n});
    } else {
      pairs_.push_back({m, 2 * n});
      pairs_.push_back({m, 2 * n + 1});
    }
  }
  return met;
}

/// Counts the edges that a ray from x to the right crosses. REQUIRES: x is not on the contour.
bool InteriorTest::inside(const Point& x, const ContourTree& contour) {
  bool inside = false;
  nodes_.assign(1, 1);
  while (!nodes_.empty()) {
    const std::uint32_t n = nodes_.back();
    nodes_.pop_back();
    const Box& box = contour.box_of(n);
    if (x.y < box.y0 || x.y > box.y1 || x.x > box.x1) continue;
    if (!contour.is_leaf(n)) {
      nodes_.push_back(2 * n);
      nodes_.push_back(2 * n + 1);
      continue;
    }
    for (std::uint32_t e = contour.first_edge(n); e < contour.last_edge(n); ++e) {
      const Point &a = contour.ring[e], &b = contour.next(e);
      if ((a.y > x.y) == (b.y > x.y)) continue;
      if (orientation(a, b, x) * (a.y < b.y ? 1 : -1) > 0) inside = !inside;
    }
  }
  return inside;
}

}  // namespace oblast::internal
