// The public triangulation: unites, triangulates, inserts the sides, finds the polygon of each triangle, and numbers.
#include <oblast/overlay.h>
#include <oblast/triangulate.h>

#include <algorithm>
#include <array>

#include "base/call_memory.h"
#include "base/public_call.h"
#include "base/stage_shares.h"
#include "regions/copy_of.h"
#include "regions/validate.h"
#include "triangulation/constrain.h"
#include "triangulation/delaunay.h"

namespace oblast {
using namespace internal;
namespace {

using namespace triangulation;

/// The sides of all polygons as constraints, and for each constraint the polygon on its left.
struct Sides {
  Array<Constraint> constraints;
  Array<std::uint32_t> polygon;
};

Sides sides_of(const RegionView& regions, const Array<std::uint32_t>& vertex_of) {
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

/// By triangle: the polygon that contains it. Starts at the left of each side, and continues to everything connected to
/// it.
Array<std::uint32_t> polygon_of_triangles(const Mesh& mesh, const Sides& sides, const Array<HalfEdge>& half_edges) {
  Array<std::uint32_t> polygon(mesh.triangles.size(), Triangulation::none);
  Array<std::uint32_t> pending;
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
Array<std::uint32_t> number_vertices(const Mesh& mesh, std::span<const Point> given, std::vector<Point>& points) {
  Array<std::uint32_t> number(mesh.points.size(), Triangulation::none);
  points.reserve(mesh.points.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    std::uint32_t& n = number[mesh.vertex_of[i]];
    if (n != Triangulation::none) continue;
    n = static_cast<std::uint32_t>(points.size());
    points.push_back(given[i]);
  }
  return number;
}

/// Copies the triangles of the requested extent into the result.
Charge write_triangles(const Mesh& mesh, const Array<std::uint32_t>& polygon, const Array<std::uint32_t>& vertex_number,
                       TriangleExtent extent, Triangulation& result) {
  Array<std::uint32_t> number(mesh.triangles.size(), Triangulation::none);
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool wanted = polygon[t] != Triangulation::none || extent == TriangleExtent::convex_hull;
    if (wanted && !mesh.triangles[t].is_ghost()) number[t] = count++;
  }
  constexpr std::size_t bytes_a_triangle =
      2 * sizeof(std::array<std::uint32_t, 3>) + sizeof(std::array<bool, 3>) + sizeof(std::uint32_t);
  Charge charge(count * bytes_a_triangle);
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
  return charge;
}

Triangulation triangulation_of(RegionSet regions, TriangleExtent extent) {
  Triangulation result;
  result.regions = std::move(regions);
  const Charge regions_and_points(bytes_of(result.regions) + result.regions.points.size() * sizeof(Point));
  check_count(result.regions.points.size(), "vertices to triangulate", most_mesh_vertices);
  Mesh mesh = delaunay(result.regions.points);
  const Array<std::uint32_t> vertex_number = number_vertices(mesh, result.regions.points, result.points);
  if (mesh.triangles.empty()) return result;
  const Sides sides = sides_of(result.regions, mesh.vertex_of);
  const Array<HalfEdge> half_edges = constrain(mesh, sides.constraints);
  const Array<std::uint32_t> polygon = polygon_of_triangles(mesh, sides, half_edges);
  const Charge triangles = write_triangles(mesh, polygon, vertex_number, extent, result);
  return result;
}

}  // namespace

Triangulation triangulate(const RegionView& regions, const TriangulateOptions& options) {
  check_overlay_options(options);
  check_enumerator(options.extent, TriangleExtent::convex_hull, "TriangleExtent");
  check_enumerator(options.input, TriangleInput::result, "TriangleInput");
  return public_call(options, options.statistics != nullptr, regions.points.size(), [&](Control& control) {
    if (options.input == TriangleInput::any) {
      RegionSet united;
      {
        const Share share(Share::current(), union_share);
        united = unite(regions, options);
      }
      control.enter(Stage::assemble);
      return triangulation_of(std::move(united), options.extent);
    }
    validate(regions, 0);
    return triangulation_of(copy_of(regions), options.extent);
  });
}

}  // namespace oblast
