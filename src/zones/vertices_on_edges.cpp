#include "zones/vertices_on_edges.h"

#include "base/call.h"
#include "exact/orientation.h"

namespace oblast::internal::zoning {

using namespace triangulation;

VerticesOnEdges::VerticesOnEdges(const Mesh& mesh) : mesh_(mesh), leaving_(mesh.points.size(), none) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i)
      if (const std::uint32_t v = mesh.triangles[t].vertex[i]; v != infinite_vertex) leaving_[v] = half_edge(t, i);
}

void VerticesOnEdges::between(std::uint32_t from, std::uint32_t to, Array<std::uint32_t>& found) const {
  if (is_side(from, to)) return;
  for (std::uint32_t v = next_on(from, to); v != to; v = next_on(v, to)) found.push_back(v);
}

/// Looks around both ends in step, so the cost is that of the smaller degree.
bool VerticesOnEdges::is_side(std::uint32_t from, std::uint32_t to) const {
  HalfEdge h = leaving_[from], g = leaving_[to];
  do {
    if (mesh_.target(h) == to || mesh_.target(g) == from) return true;
    h = mesh_.clockwise(h);
    g = mesh_.clockwise(g);
  } while (h != leaving_[from] && g != leaving_[to]);
  return false;
}

/// The first vertex after `from` on the way to `to`.
std::uint32_t VerticesOnEdges::next_on(std::uint32_t from, std::uint32_t to) const {
  Steps steps;
  const Point &p = mesh_.points[from], &q = mesh_.points[to];
  HalfEdge h = leaving_[from];
  for (;; h = mesh_.clockwise(h)) {
    steps();
    const std::uint32_t right = mesh_.target(h), left = mesh_.apex(h);
    if (right == infinite_vertex) continue;
    if (right == to) return to;
    const int side = side_of(from, to, right);
    if (side == 0) {
      const Point& r = mesh_.points[right];
      if ((r.x - p.x) * (q.x - p.x) + (r.y - p.y) * (q.y - p.y) > 0) return right;
    } else if (side < 0 && left != infinite_vertex && side_of(from, to, left) > 0) {
      break;
    }
  }
  // The way leaves the triangle by the side opposite to `from`.
  for (h = next(h);;) {
    steps();
    const HalfEdge across = mesh_.twin(h);
    const std::uint32_t apex = mesh_.apex(across);
    const int side = side_of(from, to, apex);
    if (side == 0) return apex;
    // `across` runs from the left to the right; so do all sides by which the way leaves, seen from the other side.
    h = side > 0 ? next(across) : previous(across);
  }
}

int VerticesOnEdges::side_of(std::uint32_t from, std::uint32_t to, std::uint32_t vertex) const {
  return exact::orientation(mesh_.points[from], mesh_.points[to], mesh_.points[vertex]);
}

}  // namespace oblast::internal::zoning
