// Triangles as flat arrays: each has its three vertices and, as half-edges, its three neighbours.
//
//              v[2]            half-edge 4 t + i: side i of triangle t, from v[i] to v[(i + 1) % 3],
//             /    \           the triangle on its left; twin[i] is the same side seen from the
//        2   /  t   \   1      neighbour, in the opposite direction
//           /        \         .
//        v[0] ----- v[1]
//               0
//
// One vertex at infinity closes the plane to a sphere: each side of the convex hull has a triangle to it (a ghost). So
// every half-edge has a twin, and no coordinates of a huge triangle are needed.
#pragma once

#include <oblast/point.h>

#include <cstdint>

#include "base/call_memory.h"
#include "base/index.h"

namespace oblast::internal::triangulation {

/// The vertex at infinity is no point, so it has no index among them.
inline constexpr std::uint32_t infinite_vertex = none;

using HalfEdge = std::uint32_t;
constexpr std::uint32_t triangle_of(HalfEdge h) { return h >> 2; }
constexpr std::uint32_t side_of(HalfEdge h) { return h & 3; }
constexpr HalfEdge half_edge(std::uint32_t triangle, std::uint32_t side) { return triangle << 2 | side; }
/// The next half-edge of the triangle, counter-clockwise.
constexpr HalfEdge next(HalfEdge h) { return (h & 2) ? h - 2 : h + 1; }
constexpr HalfEdge previous(HalfEdge h) { return (h & 3) ? h - 1 : h + 2; }

/// 32 bytes: two triangles per cache line.
struct Triangle {
  std::uint32_t vertex[3];
  std::uint32_t constrained;  ///< bit i: side i is constrained
  HalfEdge twin[3];
  std::uint32_t mark;  ///< used by the current algorithm; 0 between algorithms

  bool is_ghost() const {
    return ((vertex[0] | vertex[1] | vertex[2]) >> 31) != 0;  // vertices are below 2^31
  }
};

struct Mesh {
  Array<Point> points;             ///< by vertex, in the order of insertion; no two are equal
  Array<std::uint32_t> vertex_of;  ///< by given point: its vertex; equal points share one
  Array<Triangle> triangles;       ///< counter-clockwise, with ghosts; none if all points are collinear

  std::uint32_t origin(HalfEdge h) const { return triangles[triangle_of(h)].vertex[side_of(h)]; }
  std::uint32_t target(HalfEdge h) const { return origin(next(h)); }
  /// The vertex opposite to the side.
  std::uint32_t apex(HalfEdge h) const { return origin(previous(h)); }
  HalfEdge twin(HalfEdge h) const { return triangles[triangle_of(h)].twin[side_of(h)]; }
  bool is_constrained(HalfEdge h) const { return (triangles[triangle_of(h)].constrained >> side_of(h)) & 1; }
  /// The next half-edge with the same origin, clockwise.
  HalfEdge clockwise(HalfEdge h) const { return next(twin(h)); }
  HalfEdge counter_clockwise(HalfEdge h) const { return twin(previous(h)); }

  void set_twin(HalfEdge h, HalfEdge other) { triangles[triangle_of(h)].twin[side_of(h)] = other; }
  void join(HalfEdge h, HalfEdge g) {
    set_twin(h, g);
    set_twin(g, h);
  }
  void set_constrained(HalfEdge h) { triangles[triangle_of(h)].constrained |= 1U << side_of(h); }
};

}  // namespace oblast::internal::triangulation
