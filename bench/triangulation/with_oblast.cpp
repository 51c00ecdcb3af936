#include <ctime>

#include "inputs.h"
#include "triangulation/constrain.h"
#include "triangulation/delaunay.h"

namespace oblast::bench {
using namespace internal;

TriangulationRun triangulate_with_oblast(const TriangulationInput& input) {
  const std::clock_t begin = std::clock();
  triangulation::Mesh mesh = triangulation::delaunay(input.points);
  std::vector<triangulation::Constraint> constraints;
  constraints.reserve(input.sides.size());
  for (const auto& [from, to] : input.sides) constraints.push_back({mesh.vertex_of[from], mesh.vertex_of[to]});
  triangulation::constrain(mesh, constraints);
  TriangulationRun run{static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 0, 0};
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.triangles[t].is_ghost()) ++run.triangles;
    for (std::uint32_t i = 0; i < 3; ++i) run.constrained += mesh.is_constrained(triangulation::half_edge(t, i));
  }
  run.constrained /= 2;
  return run;
}

}  // namespace oblast::bench
