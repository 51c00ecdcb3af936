#include "zones/whole_cells.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"
#include "exact/orientation.h"

namespace oblast::internal::zoning {
namespace {

/// The cell of a vertex.
class Cell {
 public:
  explicit Cell(const Diagram& diagram) : diagram_(diagram) {}

  /// REQUIRES: the vertex is not on the hull.
  void go_around(std::uint32_t vertex) {
    ring.clear();
    const HalfEdge begin = diagram_.leaving[vertex];
    HalfEdge h = begin;
    do {
      const Point& p = diagram_.circle[triangulation::triangle_of(h)].centre;
      if (ring.empty() || ring.back() != p) ring.push_back(p);
      h = diagram_.mesh.counter_clockwise(h);
    } while (h != begin);
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), lexicographically_less), ring.end());
  }

  /// Whether it goes once around an area, to the left or straight on at each vertex. Along the order of coordinates
  /// such a ring turns back at its first and its last vertex only.
  bool is_convex() const {
    int turns_back = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i == 0 ? ring.size() - 1 : i - 1], &q = ring[i],
                  &r = ring[i + 1 == ring.size() ? 0 : i + 1];
      const int turn = exact::orientation(p, q, r);
      if (turn < 0) return false;
      if (lexicographically_less(p, q) == lexicographically_less(q, r)) continue;
      if (turn == 0 || ++turns_back > 2) return false;
    }
    return ring.size() > 2;
  }

  /// REQUIRES: the ring is not empty.
  Box box() const {
    Box box = Box::of(ring.front(), ring.front());
    for (const Point& p : ring) box = box.joined(p);
    return box;
  }

  Array<Point> ring;  ///< counter-clockwise, no two neighbours equal

 private:
  const Diagram& diagram_;
};

/// By vertex: whether it is the only one of its object.
Array<bool> only_ones(const Diagram& diagram, std::uint32_t rest) {
  Array<std::uint32_t> vertex_of(rest, none);
  Array<bool> only(diagram.object.size(), false);
  Steps steps(diagram.object.size());
  for (std::uint32_t v = 0; v < diagram.object.size(); ++v) {
    steps();
    if (diagram.object[v] == none) continue;
    std::uint32_t& first = vertex_of[diagram.object[v]];
    only[first == none ? v : first] = first == none;
    if (first == none) first = v;
  }
  return only;
}

/// The whole cells of a range of vertices.
struct Found {
  LargeArray<Point> points;
  Array<std::uint32_t> vertices, sizes;
};

void add_outline(const Diagram& diagram, std::uint32_t vertex, std::uint32_t rest, WholeCells& cells) {
  const Mesh& mesh = diagram.mesh;
  const HalfEdge begin = diagram.leaving[vertex];
  HalfEdge h = begin;
  do {
    // The border to the target of h comes from the triangle on its right.
    const Point &from = diagram.circle[triangulation::triangle_of(mesh.twin(h))].centre,
                &to = diagram.circle[triangulation::triangle_of(h)].centre;
    if (diagram.object[mesh.target(h)] != rest && from != to) cells.outline.push_back({from, to});
    h = mesh.counter_clockwise(h);
  } while (h != begin);
}

}  // namespace

WholeCells take_whole_cells(Diagram& diagram, const FrameInterior& frame, std::uint32_t rest) {
  const Array<bool> only = only_ones(diagram, rest);
  Array<Found> found(range_count(only.size(), tuning::cells_a_range));
  std::atomic<bool> all_convex = true;
  for_numbered_ranges(only.size(), tuning::cells_a_range, [&](std::size_t range, std::size_t v, std::size_t end) {
    Cell cell(diagram);
    Found& here = found[range];
    for (; v < end && all_convex.load(std::memory_order_relaxed); ++v) {
      if (diagram.object[v] == none) continue;
      const auto vertex = static_cast<std::uint32_t>(v);
      cell.go_around(vertex);
      if (!cell.is_convex()) {
        all_convex = false;
        return;
      }
      if (!only[v] || !frame.holds(cell.box())) continue;
      here.points.insert(here.points.end(), cell.ring.begin(), cell.ring.end());
      here.vertices.push_back(vertex);
      here.sizes.push_back(static_cast<std::uint32_t>(cell.ring.size()));
    }
  });
  if (!all_convex) return {};
  WholeCells cells;
  Array<std::size_t> begins;
  std::size_t count = 0;
  for (const Found& range : found) {
    begins.push_back(count);
    count += range.points.size();
  }
  check_count(count, "vertices of cells");
  resize_uninitialized(cells.points, count);
  for_ranges(found.size(), 1, [&](std::size_t i, std::size_t past) {
    for (; i < past; ++i) std::copy(found[i].points.begin(), found[i].points.end(), cells.points.begin() + begins[i]);
  });
  std::uint32_t end = 0;
  for (const Found& range : found) {
    for (std::size_t i = 0; i < range.vertices.size(); ++i) {
      cells.objects.push_back(diagram.object[range.vertices[i]]);
      cells.ends.push_back(end += range.sizes[i]);
      diagram.object[range.vertices[i]] = rest;
    }
  }
  for (const Found& range : found)
    for (const std::uint32_t v : range.vertices) add_outline(diagram, v, rest, cells);
  std::sort(cells.outline.begin(), cells.outline.end());
  return cells;
}

}  // namespace oblast::internal::zoning
