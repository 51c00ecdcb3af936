// Public triangulation: unite, triangulate, put the sides in, find the polygon of each triangle, number.
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <algorithm>

#include "overlay/validate.h"
#include "triangulation/constrain.h"
#include "triangulation/delaunay.h"

namespace oblast {
namespace {

using namespace triangulation;

/// The sides of all polygons as constraints, and by constraint the polygon on its left.
struct Sides {
  std::vector<Constraint> constraints;
  std::vector<std::uint32_t> polygon;
};

Sides sides_of(const RegionView& regions, const std::vector<std::uint32_t>& vertex_of) {
  Sides sides;
  sides.constraints.reserve(regions.points.size());
  sides.polygon.reserve(regions.points.size());
  for (std::uint32_t p = 0; p < regions.polygon_count(); ++p) {
    for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      const std::uint32_t begin = regions.contour_begin(c), end = regions.contour_end(c);
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t from = vertex_of[i], to = vertex_of[i + 1 == end ? begin : i + 1];
        if (from == to) continue;
        sides.constraints.push_back({from, to});
        sides.polygon.push_back(p);
      }
    }
  }
  return sides;
}

/// By triangle the polygon it is in: from each side to all that is connected with its left.
std::vector<std::uint32_t> polygon_of_triangles(const Mesh& mesh, const Sides& sides,
                                                const std::vector<HalfEdge>& half_edges) {
  std::vector<std::uint32_t> polygon(mesh.triangles.size(), Triangulation::none);
  std::vector<std::uint32_t> pending;
  const auto enter = [&](std::uint32_t t, std::uint32_t p) {
    if (polygon[t] != Triangulation::none || mesh.triangles[t].is_ghost()) return;
    polygon[t] = p;
    pending.push_back(t);
  };
  for (std::size_t k = 0; k < half_edges.size(); ++k) {
    enter(triangle_of(half_edges[k]), sides.polygon[k]);
    while (!pending.empty()) {
      const std::uint32_t t = pending.back();
      pending.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i)
        if (!mesh.is_constrained(half_edge(t, i))) enter(triangle_of(mesh.twin(half_edge(t, i))), polygon[t]);
    }
  }
  return polygon;
}

/// Numbers the vertices by their first appearance among the given points.
std::vector<std::uint32_t> number_vertices(const Mesh& mesh, const std::vector<Point>& given,
                                           std::vector<Point>& points) {
  std::vector<std::uint32_t> number(mesh.points.size(), Triangulation::none);
  points.reserve(mesh.points.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    std::uint32_t& n = number[mesh.vertex_of[i]];
    if (n != Triangulation::none) continue;
    n = static_cast<std::uint32_t>(points.size());
    points.push_back(given[i]);
  }
  return number;
}

/// Copies the triangles wanted into the result.
void write_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& polygon,
                     const std::vector<std::uint32_t>& vertex_number, TriangleExtent extent, Triangulation& result) {
  std::vector<std::uint32_t> number(mesh.triangles.size(), Triangulation::none);
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool wanted = polygon[t] != Triangulation::none || extent == TriangleExtent::convex_hull;
    if (wanted && !mesh.triangles[t].is_ghost()) number[t] = count++;
  }
  result.triangles.reserve(count);
  result.neighbours.reserve(count);
  result.is_side.reserve(count);
  result.polygon.reserve(count);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (number[t] == Triangulation::none) continue;
    const Triangle& triangle = mesh.triangles[t];
    const auto neighbour = [&](int i) { return number[triangle_of(triangle.twin[i])]; };
    const auto side = [&](int i) { return ((triangle.constrained >> i) & 1) != 0; };
    result.triangles.push_back(
        {vertex_number[triangle.vertex[0]], vertex_number[triangle.vertex[1]], vertex_number[triangle.vertex[2]]});
    result.neighbours.push_back({neighbour(0), neighbour(1), neighbour(2)});
    result.is_side.push_back({side(0), side(1), side(2)});
    result.polygon.push_back(polygon[t]);
  }
}

RegionSet copy(const RegionView& regions) {
  RegionSet copied{{regions.points.begin(), regions.points.end()},
                   {regions.contour_ends.begin(), regions.contour_ends.end()},
                   {regions.polygon_ends.begin(), regions.polygon_ends.end()}};
  return copied;
}

}  // namespace

Triangulation triangulate(const RegionView& regions, const TriangulateOptions& options) {
  Triangulation result;
  if (options.input == TriangleInput::result) {
    validate(regions, 0);
    result.regions = copy(regions);
  } else {
    result.regions = unite(regions, options.unite);
  }
  if (result.regions.points.size() >= (1U << 29))
    throw Error(ErrorCode::too_large, "more than 2^29 vertices to triangulate");

  Mesh mesh = delaunay(result.regions.points);
  const std::vector<std::uint32_t> vertex_number = number_vertices(mesh, result.regions.points, result.points);
  if (mesh.triangles.empty()) return result;
  const Sides sides = sides_of(result.regions, mesh.vertex_of);
  const std::vector<HalfEdge> half_edges = constrain(mesh, sides.constraints);
  const std::vector<std::uint32_t> polygon = polygon_of_triangles(mesh, sides, half_edges);
  write_triangles(mesh, polygon, vertex_number, options.extent, result);
  return result;
}

}  // namespace oblast
