#include "plane/smallest_vertex.h"

#include <algorithm>
#include <array>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal {
namespace {

SmallestVertex smallest_vertex_between(std::span<const Point> ring, std::size_t begin, std::size_t end) {
  // First finds the smallest x, without branches, in four independent sequences, so that no step waits for the one
  // before. Few vertices have the smallest x.
  std::array<double, 4> smallest_x;
  smallest_x.fill(ring[begin].x);
  std::size_t next = begin;
  for (; next + 4 <= end; next += 4)
    for (std::size_t k = 0; k < 4; ++k) smallest_x[k] = std::min(smallest_x[k], ring[next + k].x);
  for (; next < end; ++next) smallest_x[0] = std::min(smallest_x[0], ring[next].x);
  const double x = *std::min_element(smallest_x.begin(), smallest_x.end());
  auto v = static_cast<std::uint32_t>(begin);
  while (ring[v].x != x) ++v;
  SmallestVertex smallest{v, false};
  for (++v; v < end; ++v) {
    if (ring[v].x != x) continue;
    if (ring[v].y < ring[smallest.vertex].y)
      smallest = {v, false};
    else if (ring[v].y == ring[smallest.vertex].y)
      smallest.repeated = true;
  }
  return smallest;
}

}  // namespace

SmallestVertex smallest_vertex(std::span<const Point> ring) {
  if (ring.size() <= tuning::smallest_vertices_a_range) return smallest_vertex_between(ring, 0, ring.size());
  Array<SmallestVertex> found(range_count(ring.size(), tuning::smallest_vertices_a_range));
  for_numbered_ranges(
      ring.size(), tuning::smallest_vertices_a_range,
      [&](std::size_t i, std::size_t begin, std::size_t end) { found[i] = smallest_vertex_between(ring, begin, end); });
  SmallestVertex smallest = found[0];
  for (std::size_t i = 1; i < found.size(); ++i) {
    const Point &p = ring[found[i].vertex], &q = ring[smallest.vertex];
    if (lexicographically_less(p, q))
      smallest = found[i];
    else if (p == q)
      smallest.repeated = true;
  }
  return smallest;
}

}  // namespace oblast::internal
