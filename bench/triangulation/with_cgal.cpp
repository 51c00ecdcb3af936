#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <ctime>

#include "inputs.h"

namespace oblast::bench {

TriangulationRun triangulate_with_cgal(const TriangulationInput& input) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                                 CGAL::No_constraint_intersection_requiring_constructions_tag>;
  std::vector<Kernel::Point_2> points;
  points.reserve(input.points.size());
  for (const Point& p : input.points) points.emplace_back(p.x, p.y);
  const std::clock_t begin = std::clock();
  Triangulation triangulation;
  if (input.sides.empty())
    triangulation.insert(points.begin(), points.end());
  else
    triangulation.insert_constraints(points.begin(), points.end(), input.sides.begin(), input.sides.end());
  TriangulationRun run{static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, triangulation.number_of_faces(), 0};
  for (const auto& edge : triangulation.finite_edges()) run.constrained += triangulation.is_constrained(edge);
  return run;
}

}  // namespace oblast::bench
