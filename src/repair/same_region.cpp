#include "repair/same_region.h"

#include <algorithm>

#include "base/call_memory.h"
#include "exact/orientation.h"
#include "plane/smallest_vertex.h"
#include "repair/plain_ring.h"

namespace oblast::internal::repairing {
namespace {

using exact::orientation;

/// A ring from its smallest vertex on.
using Ring = Array<Point>;

/// An outer ring counter-clockwise, then holes clockwise.
using Polygon = Array<Ring>;

/// By the first vertex, then by the direction of the first edge. All edges that leave a smallest vertex lie within half
/// a turn.
bool comes_before(const Ring& p, const Ring& q) {
  if (p[0] != q[0]) return lexicographically_less(p[0], q[0]);
  return orientation(p[0], p[1], q[1]) > 0;
}

/// Empty if the ring cannot be one of a valid polygon.
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

/// No polygons if some ring cannot be one of a valid polygon.
Array<Polygon> polygons_in_order(const RegionView& regions) {
  Array<Polygon> polygons;
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    const std::uint32_t begin = regions.polygon_begin(p), end = regions.polygon_end(p);
    if (begin == end) continue;
    Polygon& polygon = polygons.emplace_back();
    for (std::uint32_t c = begin; c < end; ++c) {
      polygon.push_back(ring_in_order(regions.contour(c), c != begin));
      if (polygon.back().empty()) return {};
    }
    std::sort(polygon.begin() + 1, polygon.end(), comes_before);
  }
  std::sort(polygons.begin(), polygons.end(),
            [](const Polygon& p, const Polygon& q) { return comes_before(p[0], q[0]); });
  return polygons;
}

/// Whether x is on the edge from a to b, after `last`, which is a or on the edge.
bool is_further_on(const Point& x, const Point& last, const Point& a, const Point& b) {
  if (orientation(a, b, x) != 0) return false;
  const bool upward = lexicographically_less(a, b);
  return lexicographically_less(last, x) == upward && last != x && lexicographically_less(x, b) == upward && x != b;
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

}  // namespace

bool is_same_region(const RegionView& feature, const RegionView& resolved, MoreVertices more) {
  const Array<Polygon> ours = polygons_in_order(feature);
  if (ours.size() != resolved.polygon_count()) return false;
  const Array<Polygon> theirs = polygons_in_order(resolved);
  if (ours.empty()) return feature.points.empty();
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), [&](const Polygon& p, const Polygon& q) {
    return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                      [&](const Ring& r, const Ring& s) { return is_same_ring(r, s, more); });
  });
}

}  // namespace oblast::internal::repairing
