// The nearest site by CGAL's segment Delaunay graph, with exact predicates. Arguments as in sites.h.
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include "zones/oracles/sites.h"

namespace {

using zones::Site;
using Kernel = CGAL::Simple_cartesian<double>;
using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel, CGAL::Field_with_sqrt_tag>;
using Graph = CGAL::Segment_Delaunay_graph_2<Traits>;

}  // namespace

int main(int argc, char** argv) {
  Graph graph;
  return zones::answer(argc, argv, [&](const zones::Sites& sites) {
    std::vector<Kernel::Point_2> points;
    std::vector<std::pair<Kernel::Point_2, Kernel::Point_2>> segments;
    for (const Site& s : sites.points) points.emplace_back(s.x0, s.y0);
    for (const Site& s : sites.segments)
      segments.emplace_back(Kernel::Point_2(s.x0, s.y0), Kernel::Point_2(s.x1, s.y1));
    graph.insert_points(points.begin(), points.end());
    graph.insert_segments(segments.begin(), segments.end());
    return [&graph, near = Graph::Vertex_handle()](const zones::Xy& p) mutable {
      near = graph.nearest_neighbor(Kernel::Point_2(p.x, p.y), near);
      const auto site = near->site();
      const auto a = site.is_point() ? site.point() : site.source(), b = site.is_point() ? a : site.target();
      return Site{int(a.x()), int(a.y()), int(b.x()), int(b.y())};
    };
  });
}
