// compare_triangulations POINTS...: runs both libraries alternately on each input; the best of 7 to 100 runs each.
//
// Times are processor time of one thread, from the points and sides in memory to the triangulation. Growth is our time
// per point divided by that of the size before.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "inputs.h"

int main(int argc, char** argv) {
  using namespace oblast::bench;
  bool agree = true;
  std::printf("%-10s %9s %9s %9s %14s %14s %7s %9s %7s\n", "input", "points", "sides", "triangles", "oblast tri/s",
              "CGAL tri/s", "ratio", "ns/point", "growth");
  std::map<std::string, double> before;  // ns a point
  for (int i = 1; i < argc; ++i) {
    for (const NamedInput& named : triangulation_inputs()) {
      const TriangulationInput input = named.make(static_cast<std::size_t>(std::atoll(argv[i])));
      TriangulationRun ours{1e300, 0, 0}, cgal{1e300, 0, 0};
      const std::size_t runs = std::clamp<std::size_t>(5000000 / input.points.size(), 7, 100);
      for (std::size_t run = 0; run < runs; ++run) {
        const auto faster = [](const TriangulationRun& p, const TriangulationRun& q) { return p.seconds < q.seconds; };
        ours = std::min(ours, triangulate_with_oblast(input), faster);
        cgal = std::min(cgal, triangulate_with_cgal(input), faster);
      }
      agree = agree && ours.triangles == cgal.triangles && ours.constrained == cgal.constrained;
      const auto rate = [](const TriangulationRun& r) { return static_cast<double>(r.triangles) / r.seconds; };
      std::printf("%-10s %9zu %9zu %9zu %14.0f %14.0f %7.2f", named.name, input.points.size(), input.sides.size(),
                  ours.triangles, rate(ours), rate(cgal), rate(ours) / rate(cgal));
      const double each = ours.seconds / static_cast<double>(input.points.size()) * 1e9;
      std::printf(" %9.0f", each);
      if (before.count(named.name)) std::printf(" %7.2f", each / before[named.name]);
      std::printf("\n");
      before[named.name] = each;
      std::fflush(stdout);
    }
  }
  if (!agree) std::printf("the two disagree about triangles or constrained sides\n");
  return agree ? 0 : 1;
}
