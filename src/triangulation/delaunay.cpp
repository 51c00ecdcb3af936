#include "triangulation/delaunay.h"

#include <numeric>

#include "base/parallel.h"
#include "triangulation/growing_delaunay.h"

namespace oblast::internal::triangulation {
namespace {

void number_collinear_points(std::span<const Point> points, Mesh& mesh) {
  Array<std::uint32_t> along(points.size());
  std::iota(along.begin(), along.end(), 0U);
  parallel_sort(along.begin(), along.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points[i] != points[j] ? lexicographically_less(points[i], points[j]) : i < j;
  });
  mesh.vertex_of.resize(points.size());
  for (const std::uint32_t i : along) {
    if (mesh.points.empty() || mesh.points.back() != points[i]) mesh.points.push_back(points[i]);
    mesh.vertex_of[i] = static_cast<std::uint32_t>(mesh.points.size() - 1);
  }
}

}  // namespace

Mesh delaunay(std::span<const Point> points) {
  Mesh mesh;
  if (!GrowingDelaunay(mesh).add(points)) number_collinear_points(points, mesh);
  return mesh;
}

}  // namespace oblast::internal::triangulation
