#include "repair/ordered_ring.h"

#include <algorithm>

#include "exact/orientation.h"
#include "plane/smallest_vertex.h"
#include "repair/plain_ring.h"

namespace oblast::internal::repairing {
namespace {

using exact::orientation;

/// Whether x is on the edge from a to b, after `last`, which is a or on the edge.
bool is_further_on(const Point& x, const Point& last, const Point& a, const Point& b) {
  if (orientation(a, b, x) != 0) return false;
  const bool upward = lexicographically_less(a, b);
  return lexicographically_less(last, x) == upward && last != x && lexicographically_less(x, b) == upward && x != b;
}

}  // namespace

// All edges that leave a smallest vertex lie within half a turn.
bool comes_before(const Ring& p, const Ring& q) {
  if (p[0] != q[0]) return lexicographically_less(p[0], q[0]);
  return orientation(p[0], p[1], q[1]) > 0;
}

Ring ring_in_order(std::span<const Point> ring, bool is_hole) {
  Ring plain = plain_ring(ring);
  if (plain.size() < 3) return {};
  const SmallestVertex smallest = smallest_vertex(plain);
  if (smallest.repeated) return {};
  std::rotate(plain.begin(), plain.begin() + smallest.vertex, plain.end());
  const int turn = orientation(plain.back(), plain[0], plain[1]);
  if (turn == 0) return {};
  if ((turn < 0) != is_hole) std::reverse(plain.begin() + 1, plain.end());
  return plain;
}

bool is_same_ring(const Ring& ring, const Ring& resolved, MoreVertices more) {
  if (more == MoreVertices::refused || ring.size() == resolved.size())
    return std::equal(ring.begin(), ring.end(), resolved.begin(), resolved.end());
  if (ring[0] != resolved[0]) return false;
  std::size_t edge = 0;  // of the ring
  for (std::size_t i = 1; i <= resolved.size(); ++i) {
    const Point &x = resolved[i % resolved.size()], &to = ring[(edge + 1) % ring.size()];
    if (x == to)
      ++edge;
    else if (!is_further_on(x, resolved[i - 1], ring[edge], to))
      return false;
    if (edge == ring.size()) return i == resolved.size();
  }
  return false;
}

}  // namespace oblast::internal::repairing
