#include "triangulation/flip.h"

#include "base/call_memory.h"
#include "exact/in_circle.h"

namespace oblast::internal::triangulation {
namespace {

bool is_illegal(const Mesh& mesh, HalfEdge h) {
  if (mesh.is_constrained(h)) return false;
  const std::uint32_t c = mesh.apex(h), d = mesh.apex(mesh.twin(h));
  if (((c | d) >> 31) != 0) return false;  // a side of the convex hull
  const auto& points = mesh.points;
  return exact::in_circle(points[mesh.origin(h)], points[mesh.target(h)], points[c], points[d]) > 0;
}

/// A side that stays while its triangles are replaced.
struct Kept {
  HalfEdge twin;
  std::uint32_t constrained;
};

Kept keep(const Mesh& mesh, HalfEdge h) { return {mesh.twin(h), mesh.is_constrained(h) ? 1U : 0U}; }

void make(Mesh& mesh, std::uint32_t t, const std::uint32_t (&vertex)[3], Kept side0, Kept side1) {
  Triangle& made = mesh.triangles[t];
  for (int i = 0; i < 3; ++i) made.vertex[i] = vertex[i];
  made.constrained = side0.constrained | side1.constrained << 1;
  mesh.join(half_edge(t, 0), side0.twin);
  mesh.join(half_edge(t, 1), side1.twin);
}

///      c                 c
///     / \              / | \        t = (c, a, d)
///    a - b    ->      a t|u b       u = (d, b, c)
///     \ /              \ | /        .
///      d                 d
void flip(Mesh& mesh, HalfEdge ab, Array<HalfEdge>& leaving, Array<HalfEdge>& suspects) {
  const HalfEdge ba = mesh.twin(ab);
  const std::uint32_t a = mesh.origin(ab), b = mesh.origin(ba), c = mesh.apex(ab), d = mesh.apex(ba);
  const Kept bc = keep(mesh, next(ab)), ca = keep(mesh, previous(ab));
  const Kept ad = keep(mesh, next(ba)), db = keep(mesh, previous(ba));
  const std::uint32_t t = triangle_of(ab), u = triangle_of(ba);
  make(mesh, t, {c, a, d}, ca, ad);
  make(mesh, u, {d, b, c}, db, bc);
  mesh.join(half_edge(t, 2), half_edge(u, 2));
  leaving[c] = half_edge(t, 0);
  leaving[a] = half_edge(t, 1);
  leaving[d] = half_edge(u, 0);
  leaving[b] = half_edge(u, 1);
  suspects.insert(suspects.end(), {half_edge(t, 0), half_edge(t, 1), half_edge(u, 0), half_edge(u, 1)});
}

}  // namespace

void make_delaunay(Mesh& mesh, Array<HalfEdge>& leaving, Array<HalfEdge>& suspects) {
  while (!suspects.empty()) {
    const HalfEdge h = suspects.back();
    suspects.pop_back();
    if (is_illegal(mesh, h)) flip(mesh, h, leaving, suspects);
  }
}

}  // namespace oblast::internal::triangulation
