#include "zones/diagram.h"

#include <algorithm>

#include "base/parallel.h"
#include "exact/circumcentre.h"
#include "zones/distance.h"

namespace oblast::internal::zoning {

void GrowingDiagram::add(std::span<const Site> sites) {
  Mesh& mesh = diagram_.mesh;
  const std::size_t first_site = mesh.vertex_of.size(), first_vertex = mesh.points.size();
  check_count(first_site + sites.size(), "sites (points, and samples of lines and outlines)", most_mesh_vertices);
  {
    LargeArray<Point> points;
    resize_uninitialized(points, sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) points[i] = sites[i].at;
    delaunay_.add(points);
  }
  const bool is_first = first_site == 0;
  const std::size_t count = is_first ? mesh.triangles.size() : delaunay_.changed().size();
  const auto changed = [&](std::size_t i) { return is_first ? static_cast<std::uint32_t>(i) : delaunay_.changed()[i]; };
  diagram_.leaving.resize(mesh.points.size(), none);
  Steps steps(count);
  for (std::size_t k = 0; k < count; ++k) {
    steps();
    const std::uint32_t t = changed(k);
    for (std::uint32_t i = 0; i < 3; ++i)
      if (const std::uint32_t v = mesh.triangles[t].vertex[i]; v != triangulation::infinite_vertex)
        diagram_.leaving[v] = triangulation::half_edge(t, i);
  }
  grow_uninitialized(diagram_.circle, mesh.triangles.size());
  give_objects(sites, first_site, first_vertex);
  for_ranges(count, tuning::centres_a_task, [&](std::size_t k, std::size_t end) {
    for (; k < end; ++k) update(changed(k));
  });
}

void GrowingDiagram::give_objects(std::span<const Site> sites, std::size_t first_site, std::size_t first_vertex) {
  const Mesh& mesh = diagram_.mesh;
  diagram_.object.resize(mesh.points.size(), none);
  if (!contacts_.empty()) diagram_.contact.resize(mesh.points.size(), none);
  Steps steps(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    steps();
    const std::uint32_t v = mesh.vertex_of[first_site + i];
    std::uint32_t& object = diagram_.object[v];
    const bool was_there = v < first_vertex;
    if (sites[i].object > object || (was_there && sites[i].object == object)) continue;
    if (!contacts_.empty()) diagram_.contact[v] = sites[i].contact;
    object = sites[i].object;
    if (!was_there) continue;
    HalfEdge h = diagram_.leaving[v];
    do {
      delaunay_.touch(triangulation::triangle_of(h));
      update(triangulation::triangle_of(h));
      h = mesh.clockwise(h);
    } while (h != diagram_.leaving[v]);
  }
}

void GrowingDiagram::update(std::uint32_t triangle) {
  const Mesh& mesh = diagram_.mesh;
  if (mesh.triangles[triangle].is_ghost()) return;
  const auto [a, b, c] = mesh.triangles[triangle].vertex;
  const std::uint32_t contact = diagram_.contact_of(triangle);
  const Point centre =
      contact != none ? contacts_[contact].at : exact::circumcentre(mesh.points[a], mesh.points[b], mesh.points[c]);
  diagram_.circle[triangle] = {centre, distance(centre, mesh.points[a])};
}

}  // namespace oblast::internal::zoning
