#include "engines/skvortsov/contours.h"

#include "base/call.h"
#include "base/call_memory.h"
#include "exact/orientation.h"

namespace oblast::internal::skvortsov {
namespace {

using namespace triangulation;

class Walking {
 public:
  Walking(const Mesh& mesh, const Kept& kept, ContourConvention convention)
      : mesh_(mesh),
        kept_(kept),
        parts_walks_(convention == ContourConvention::ogc),
        polygon_(mesh.triangles.size(), none),
        walked_(4 * mesh.triangles.size(), false) {
    if (parts_walks_) place_on_path_.assign(mesh.points.size(), none);
  }

  Contours run() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      if (kept_[t] && polygon_[t] == none) flood(t);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!kept_[t]) continue;
      for (std::uint32_t i = 0; i < 3; ++i)
        if (is_boundary(half_edge(t, i)) && !walked_[half_edge(t, i)]) walk(half_edge(t, i));
    }
    return std::move(contours_);
  }

 private:
  bool is_boundary(HalfEdge h) const { return kept_[triangle_of(h)] && !kept_[triangle_of(mesh_.twin(h))]; }

  /// One polygon: all kept triangles connected by sides.
  void flood(std::uint32_t seed) {
    const std::uint32_t polygon = contours_.nesting.polygon_count++;
    polygon_[seed] = polygon;
    pending_.push_back(seed);
    while (!pending_.empty()) {
      steps_();
      const std::uint32_t t = pending_.back();
      pending_.pop_back();
      for (const HalfEdge twin : mesh_.triangles[t].twin) {
        const std::uint32_t beyond = triangle_of(twin);
        if (!kept_[beyond] || polygon_[beyond] != none) continue;
        polygon_[beyond] = polygon;
        pending_.push_back(beyond);
      }
    }
  }

  /// The paper's step A, with its rule against contours that cross themselves.
  HalfEdge boundary_after(HalfEdge h) const {
    HalfEdge w = next(h);
    while (!is_boundary(w)) w = mesh_.clockwise(w);
    return w;
  }

  void walk(HalfEdge first) {
    const std::uint32_t polygon = polygon_[triangle_of(first)];
    HalfEdge h = first;
    do {
      steps_();
      walked_[h] = true;
      const std::uint32_t v = mesh_.origin(h);
      if (parts_walks_) part_at(v, polygon);
      path_.push_back(v);
      h = boundary_after(h);
    } while (h != first);
    if (parts_walks_)
      for (const std::uint32_t v : path_) place_on_path_[v] = none;
    emit(0, polygon);
  }

  /// The walk is at `v`. If it was here before, the vertices since then are a separate contour.
  void part_at(std::uint32_t v, std::uint32_t polygon) {
    if (const std::uint32_t place = place_on_path_[v]; place != none) {
      for (std::size_t i = place; i < path_.size(); ++i) place_on_path_[path_[i]] = none;
      emit(place, polygon);
    }
    place_on_path_[v] = static_cast<std::uint32_t>(path_.size());
  }

  void emit(std::size_t begin, std::uint32_t polygon) {
    const std::span contour = std::span(path_).subspan(begin);
    contours_.vertices.insert(contours_.vertices.end(), contour.begin(), contour.end());
    contours_.ends.push_back(static_cast<std::uint32_t>(contours_.vertices.size()));
    contours_.nesting.polygon.push_back(polygon);
    contours_.nesting.outer.push_back(is_outer(contour));
    path_.resize(begin);
  }

  /// True if the contour is counter-clockwise: it turns left each time it visits its smallest vertex. (A hole that
  /// touches itself there turns right once.)
  bool is_outer(std::span<const std::uint32_t> contour) const {
    const auto point = [&](std::size_t i) -> const Point& { return mesh_.points[contour[i]]; };
    std::size_t smallest = 0;
    for (std::size_t i = 1; i < contour.size(); ++i)
      if (lexicographically_less(point(i), point(smallest))) smallest = i;
    for (std::size_t i = smallest; i < contour.size(); ++i) {
      if (contour[i] != contour[smallest]) continue;
      const Point& before = point(i == 0 ? contour.size() - 1 : i - 1);
      const Point& after = point(i + 1 == contour.size() ? 0 : i + 1);
      if (exact::orientation(before, point(i), after) < 0) return false;
    }
    return true;
  }

  const Mesh& mesh_;
  const Kept& kept_;
  bool parts_walks_;
  Array<std::uint32_t> polygon_;  ///< by triangle
  Array<bool> walked_;            ///< by half-edge
  Array<std::uint32_t> pending_;
  Steps steps_;
  Array<std::uint32_t> path_;           ///< vertices of the walk, without contours that were separated
  Array<std::uint32_t> place_on_path_;  ///< by vertex
  Contours contours_;
};

}  // namespace

Contours walk_contours(const Mesh& mesh, const Kept& kept, ContourConvention convention) {
  return Walking(mesh, kept, convention).run();
}

}  // namespace oblast::internal::skvortsov
