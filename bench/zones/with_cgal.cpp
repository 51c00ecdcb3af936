// CGAL: the Delaunay triangulation with exact predicates; cells are the circumcentres around each vertex. Arguments as
// in shape_file.h, of which distance and segments are not used.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "zones/cells.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

buffers::Shapes cells_of(const std::vector<buffers::Xy>& points) {
  const zones::Frame frame(points);
  std::vector<Kernel::Point_2> sites;
  sites.reserve(points.size() + 4);
  for (const auto& p : points) sites.emplace_back(p.x, p.y);
  for (const auto& p : frame.far_away()) sites.emplace_back(p.x, p.y);
  const Triangulation triangulation(sites.begin(), sites.end());
  buffers::Shapes cells;
  std::vector<buffers::Xy> ring;
  for (const auto vertex : triangulation.finite_vertex_handles()) {
    const auto& p = vertex->point();
    if (!frame.holds({p.x(), p.y()})) continue;
    ring.clear();
    auto face = triangulation.incident_faces(vertex);
    const auto first = face;
    do {
      const auto centre = triangulation.circumcenter(face);
      ring.push_back({centre.x(), centre.y()});
    } while (++face != first);
    zones::add_cell(ring, frame, cells);
  }
  return cells;
}

}  // namespace

int main(int argc, char** argv) { return zones::drive(argc, argv, cells_of); }
