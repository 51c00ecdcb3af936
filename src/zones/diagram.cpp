#include "zones/diagram.h"

#include <algorithm>

#include "base/parallel.h"
#include "exact/circumcentre.h"
#include "triangulation/delaunay.h"

namespace oblast::internal::zoning {

Diagram make_diagram(std::span<const Site> sites, std::span<const Contact> contacts) {
  Diagram diagram;
  check_count(sites.size(), "sites (points, and samples of lines and outlines)", most_mesh_vertices);
  {
    LargeArray<Point> points;
    resize_uninitialized(points, sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) points[i] = sites[i].at;
    diagram.mesh = triangulation::delaunay(points);
  }
  const Mesh& mesh = diagram.mesh;
  diagram.object.assign(mesh.points.size(), none);
  diagram.contact.assign(contacts.empty() ? 0 : mesh.points.size(), none);
  Steps steps(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    steps();
    std::uint32_t& object = diagram.object[mesh.vertex_of[i]];
    if (!contacts.empty() && sites[i].object <= object) diagram.contact[mesh.vertex_of[i]] = sites[i].contact;
    object = std::min(object, sites[i].object);
  }
  resize_uninitialized(diagram.centre, mesh.triangles.size());
  for_ranges(mesh.triangles.size(), tuning::centres_a_task, [&](std::size_t t, std::size_t end) {
    for (; t < end; ++t) {
      const triangulation::Triangle& triangle = mesh.triangles[t];
      if (triangle.is_ghost()) continue;
      const std::uint32_t contact = diagram.contact_of(static_cast<std::uint32_t>(t));
      const auto [a, b, c] = triangle.vertex;
      diagram.centre[t] =
          contact != none ? contacts[contact].at : exact::circumcentre(mesh.points[a], mesh.points[b], mesh.points[c]);
    }
  });
  return diagram;
}

}  // namespace oblast::internal::zoning
