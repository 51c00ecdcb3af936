#include "triangulation/locate.h"

#include "exact/orientation.h"

namespace oblast::internal::triangulation {
namespace {

using exact::orientation;

/// The place of a point that is not right of any side. `s0`, `s1`, `s2`: the orientations with `at` and the sides after
/// it.
Place settled(HalfEdge at, int s0, int s1, int s2) {
  const HalfEdge h1 = next(at), h2 = previous(at);
  if (s0 == 0 && s1 == 0) return {Place::Kind::at_vertex, h1};
  if (s1 == 0 && s2 == 0) return {Place::Kind::at_vertex, h2};
  if (s2 == 0 && s0 == 0) return {Place::Kind::at_vertex, at};
  if (s0 == 0) return {Place::Kind::on_side, at};
  if (s1 == 0) return {Place::Kind::on_side, h1};
  if (s2 == 0) return {Place::Kind::on_side, h2};
  return {Place::Kind::inside, at};
}

/// The side from which the walk begins: a side of a triangle that is not a ghost.
HalfEdge first_side(const Mesh& mesh, std::uint32_t start) {
  const Triangle& t = mesh.triangles[start];
  if (!t.is_ghost()) return half_edge(start, 0);
  return mesh.twin(half_edge(start, t.vertex[0] == infinite_vertex ? 1 : t.vertex[1] == infinite_vertex ? 2 : 0));
}

}  // namespace

Place locate(const Mesh& mesh, std::uint32_t start, const Point& p) {
  const auto side = [&](std::uint32_t a, std::uint32_t b) { return orientation(mesh.points[a], mesh.points[b], p); };
  HalfEdge at =
      first_side(mesh, start);  // the side crossed last; p lies on its left (at the beginning, possibly on it)
  int s0 = side(mesh.origin(at), mesh.target(at));
  if (s0 < 0) {
    at = mesh.twin(at);
    s0 = 1;
  }
  for (;;) {
    if (mesh.triangles[triangle_of(at)].is_ghost()) return {Place::Kind::inside, at};
    const HalfEdge h1 = next(at), h2 = previous(at);
    const std::uint32_t apex = mesh.origin(h2);
    const int s1 = side(mesh.origin(h1), apex);
    const int s2 = s1 < 0 ? 0 : side(apex, mesh.origin(at));
    if (s1 >= 0 && s2 >= 0) return settled(at, s0, s1, s2);
    at = mesh.twin(s1 < 0 ? h1 : h2);
    s0 = 1;
  }
}

}  // namespace oblast::internal::triangulation
