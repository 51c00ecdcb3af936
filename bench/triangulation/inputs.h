// The inputs of triangulations: points, and sides between them that do not cross.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace oblast::bench {

struct TriangulationInput {
  std::vector<Point> points;
  std::vector<std::pair<std::size_t, std::size_t>> sides;
};

struct NamedInput {
  const char* name;
  TriangulationInput (*make)(std::size_t points);
};

std::span<const NamedInput> triangulation_inputs();

/// Seconds of processor time, and the number of triangles in the convex hull. The number of sides shows that both
/// libraries did the same.
struct TriangulationRun {
  double seconds;
  std::size_t triangles;
  std::size_t constrained;
};

TriangulationRun triangulate_with_oblast(const TriangulationInput& input);
TriangulationRun triangulate_with_cgal(const TriangulationInput& input);

}  // namespace oblast::bench
