// How two edges meet, other than in a common end.
#pragma once

#include <oblast/point.h>

#include <cstdint>

#include "exact/intersection_point.h"
#include "exact/orientation.h"
#include "plane/box.h"

namespace oblast::internal::checking {

enum class EdgeContact : std::uint8_t {
  cross,           ///< inside both
  along,           ///< they have a stretch in common
  vertex_on_edge,  ///< the vertex at which one begins lies inside the other
};

/// Whether two edges that leave one point go the same way.
inline bool same_way(const Point& at, const Point& u, const Point& v) {
  return lexicographically_less(at, u) == lexicographically_less(at, v) && exact::orientation(at, u, v) == 0;
}

/// Calls found(contact, i, j, point) for each contact of the edges i and j; of vertex_on_edge the first index is the
/// vertex and the second one the edge. Exact.
///
///        d                 a, b: ends of edge i;  c, d: ends of edge j
///   a ---+--- b            +: the contact
///        c
template <class Found>
void for_contacts(const Point* points, std::uint32_t i, std::uint32_t j, const Found& found) {
  const Point &a = points[i], &b = points[i + 1], &c = points[j], &d = points[j + 1];
  const Box ab = Box::of(a, b), cd = Box::of(c, d);
  if (!ab.meets(cd)) return;
  const int c_side = exact::orientation(a, b, c), d_side = exact::orientation(a, b, d);
  if (c_side * d_side > 0) return;
  if (c_side == 0 && d_side == 0) {
    // On one line: they have a stretch in common unless they only meet in an end of both.
    const auto inside = [](const Point& p, const Box& box, const Point& u, const Point& v) {
      return p != u && p != v && box.contains(p);
    };
    const bool c_in = inside(c, ab, a, b), d_in = inside(d, ab, a, b), a_in = inside(a, cd, c, d),
               b_in = inside(b, cd, c, d);
    const bool identical = (a == c && b == d) || (a == d && b == c);
    if (!identical && !c_in && !d_in && !a_in && !b_in) return;
    found(EdgeContact::along, i, j, ab.contains(c) ? c : ab.contains(d) ? d : a);
    if (c_in) found(EdgeContact::vertex_on_edge, j, i, c);
    if (a_in) found(EdgeContact::vertex_on_edge, i, j, a);
    return;
  }
  const int a_side = exact::orientation(c, d, a), b_side = exact::orientation(c, d, b);
  if (a_side * b_side > 0) return;
  if (c_side != 0 && d_side != 0 && a_side != 0 && b_side != 0) {
    found(EdgeContact::cross, i, j, exact::intersection_point(a, b, c, d));
    return;
  }
  if (c_side == 0 && c != a && c != b) found(EdgeContact::vertex_on_edge, j, i, c);
  if (a_side == 0 && a != c && a != d) found(EdgeContact::vertex_on_edge, i, j, a);
}

}  // namespace oblast::internal::checking
