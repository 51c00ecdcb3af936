#include "triangulation/delaunay.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "base/large_pages.h"
#include "base/parallel.h"
#include "exact/in_circle.h"
#include "exact/orientation.h"
#include "triangulation/locate.h"
#include "triangulation/spatial_order.h"

namespace oblast::internal::triangulation {
namespace {

using exact::in_circle;
using exact::orientation;

class Insertion {
 public:
  explicit Insertion(std::span<const Point> given) : order_(spatial_order(given)) {
    // The points are gathered once. Otherwise each later step would wait for memory.
    reserve_in_large_pages(mesh_.points, given.size());
    for (const std::uint32_t index : order_) mesh_.points.push_back(given[index]);
  }

  Mesh run() {
    resize_with_zeros(mesh_.vertex_of, order_.size());
    if (first_triangle()) {
      Steps steps(order_.size());
      for (std::uint32_t i = 3; i < order_.size(); ++i) {
        steps();
        insert(i);
      }
    } else {
      number_collinear_points();
    }
    mesh_.points.resize(vertices_);
    return std::move(mesh_);
  }

 private:
  /// Makes the point at position `i` of the order a vertex. Equal points become one vertex.
  std::uint32_t add_vertex(std::uint32_t i) {
    mesh_.points[vertices_] = mesh_.points[i];
    mesh_.vertex_of[order_[i]] = vertices_;
    return vertices_++;
  }

  void swap_places(std::size_t i, std::size_t j) {
    std::swap(order_[i], order_[j]);
    std::swap(mesh_.points[i], mesh_.points[j]);
  }

  /// Moves three points that are not collinear to the front of the order. False if there are none.
  bool find_three() {
    const Array<Point>& points = mesh_.points;
    std::size_t second = 1, third = 2;
    while (second < points.size() && points[second] == points[0]) ++second;
    if (second >= points.size()) return false;
    swap_places(1, second);
    while (third < points.size() && orientation(points[0], points[1], points[third]) == 0) ++third;
    if (third >= points.size()) return false;
    swap_places(2, third);
    if (orientation(points[0], points[1], points[2]) < 0) swap_places(0, 1);
    return true;
  }

  bool first_triangle() {
    if (!find_three()) return false;
    reserve_in_large_pages(mesh_.triangles, 2 * order_.size());
    const std::uint32_t a = add_vertex(0), b = add_vertex(1), c = add_vertex(2);
    // Triangle 0, and the ghosts 1, 2, 3 beyond its sides 0, 1, 2.
    mesh_.triangles.push_back({{a, b, c}, 0, {half_edge(1, 0), half_edge(2, 0), half_edge(3, 0)}, 0});
    mesh_.triangles.push_back({{b, a, infinite_vertex}, 0, {half_edge(0, 0), half_edge(3, 2), half_edge(2, 1)}, 0});
    mesh_.triangles.push_back({{c, b, infinite_vertex}, 0, {half_edge(0, 1), half_edge(1, 2), half_edge(3, 1)}, 0});
    mesh_.triangles.push_back({{a, c, infinite_vertex}, 0, {half_edge(0, 2), half_edge(2, 2), half_edge(1, 1)}, 0});
    return true;
  }

  void number_collinear_points() {
    Array<std::uint32_t> along(order_.size());
    std::iota(along.begin(), along.end(), 0U);
    const Array<Point> points = mesh_.points;
    parallel_sort(along.begin(), along.end(),
                  [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(points[i], points[j]); });
    for (const std::uint32_t i : along) {
      if (vertices_ == 0 || mesh_.points[vertices_ - 1] != points[i]) mesh_.points[vertices_++] = points[i];
      mesh_.vertex_of[order_[i]] = vertices_ - 1;
    }
  }

  void insert(std::uint32_t i) {
    const Place place = locate(mesh_, last_, mesh_.points[i]);
    if (place.kind == Place::Kind::at_vertex) {
      mesh_.vertex_of[order_[i]] = mesh_.origin(place.half_edge);
      last_ = triangle_of(place.half_edge);
      return;
    }
    const std::uint32_t v = add_vertex(i);
    if (place.kind == Place::Kind::inside)
      part_triangle(triangle_of(place.half_edge), v);
    else
      part_side(place.half_edge, v);
    flip_illegal(v);
  }

  std::uint32_t add_triangle() {
    mesh_.triangles.push_back({});
    return static_cast<std::uint32_t>(mesh_.triangles.size() - 1);
  }

  /// Makes the triangle (p, a, b) with p as vertex 0. Its side 1 will be tested. The caller sets the twins of sides 0
  /// and 2.
  void make(std::uint32_t t, std::uint32_t p, std::uint32_t a, std::uint32_t b, HalfEdge beyond) {
    Triangle& made = mesh_.triangles[t];
    made.vertex[0] = p;
    made.vertex[1] = a;
    made.vertex[2] = b;
    made.twin[1] = beyond;
    mesh_.set_twin(beyond, half_edge(t, 1));
    suspects_.push_back(t);
  }

  /// Makes side 2 of `before` and side 0 of `after` twins.
  void join_around(std::uint32_t before, std::uint32_t after) {
    mesh_.triangles[before].twin[2] = half_edge(after, 0);
    mesh_.triangles[after].twin[0] = half_edge(before, 2);
  }

  ///        c
  ///       /|\          three triangles with p at vertex 0, one for each side
  ///      / p \         .
  ///     a --- b
  void part_triangle(std::uint32_t t, std::uint32_t p) {
    const Triangle old = mesh_.triangles[t];
    const std::uint32_t u = add_triangle(), w = add_triangle();
    make(t, p, old.vertex[0], old.vertex[1], old.twin[0]);
    make(u, p, old.vertex[1], old.vertex[2], old.twin[1]);
    make(w, p, old.vertex[2], old.vertex[0], old.twin[2]);
    join_around(t, u);
    join_around(u, w);
    join_around(w, t);
  }

  ///        c
  ///       /|\          p on the side from a to b: four triangles
  ///     a--p--b        .
  ///       \|/
  ///        d
  void part_side(HalfEdge h, std::uint32_t p) {
    const HalfEdge g = mesh_.twin(h);
    const std::uint32_t a = mesh_.origin(h), b = mesh_.origin(g), c = mesh_.apex(h), d = mesh_.apex(g);
    const HalfEdge bc = mesh_.twin(next(h)), ca = mesh_.twin(previous(h));
    const HalfEdge ad = mesh_.twin(next(g)), db = mesh_.twin(previous(g));
    const std::uint32_t t = triangle_of(h), u = triangle_of(g), v = add_triangle(), w = add_triangle();
    make(t, p, b, c, bc);
    make(v, p, c, a, ca);
    make(u, p, a, d, ad);
    make(w, p, d, b, db);
    join_around(t, v);
    join_around(v, u);
    join_around(u, w);
    join_around(w, t);
  }

  /// Lawson's flips. All suspects have the new point p at vertex 0:
  ///
  ///        b                   b
  ///      / | \               / u \      t = (p, a, b) and u = (b, a, c) become
  ///    p t | u c    ->     p ----- c    t = (p, a, c) and u = (p, c, b)
  ///      \ | /               \ t /      .
  ///        a                   a
  void flip_illegal(std::uint32_t p) {
    std::uint32_t t = 0;
    while (!suspects_.empty()) {
      flips_();
      t = suspects_.back();
      suspects_.pop_back();
      for (;;) {
        const HalfEdge g = mesh_.triangles[t].twin[1];
        const std::uint32_t c = mesh_.apex(g);
        if (!is_illegal(mesh_.triangles[t], p, c)) break;
        const std::uint32_t u = triangle_of(g);
        Triangle& low = mesh_.triangles[t];
        Triangle& high = mesh_.triangles[u];
        const HalfEdge ac = high.twin[side_of(next(g))], cb = high.twin[side_of(previous(g))];
        const std::uint32_t b = low.vertex[2];
        const HalfEdge after = low.twin[2];
        high.vertex[0] = p;
        high.vertex[1] = c;
        high.vertex[2] = b;
        high.twin[0] = half_edge(t, 2);
        high.twin[1] = cb;
        high.twin[2] = after;
        mesh_.set_twin(cb, half_edge(u, 1));
        mesh_.set_twin(after, half_edge(u, 2));
        low.vertex[2] = c;
        low.twin[1] = ac;
        low.twin[2] = half_edge(u, 0);
        mesh_.set_twin(ac, half_edge(t, 1));
        suspects_.push_back(u);
      }
    }
    last_ = t;
  }

  /// True if c is inside the circle of t = (p, a, b). The circle of a ghost is the half-plane beyond its side of the
  /// hull.
  bool is_illegal(const Triangle& t, std::uint32_t p, std::uint32_t c) const {
    const std::uint32_t a = t.vertex[1], b = t.vertex[2];
    const auto& points = mesh_.points;
    if (((a | b | c) >> 31) == 0) return in_circle(points[p], points[a], points[b], points[c]) > 0;
    if (c == infinite_vertex) return false;
    // t and its neighbour are ghosts with the sides (b, p) and (c, b), or (p, a) and (a, c). p may see the side of the
    // neighbour, too.
    if (a == infinite_vertex) return orientation(points[c], points[b], points[p]) > 0;
    return orientation(points[a], points[c], points[p]) > 0;
  }

  Array<std::uint32_t> order_;  ///< indices of the given points
  Mesh mesh_;                   ///< points: the vertices, then those not yet inserted, in order
  std::uint32_t vertices_ = 0;
  Array<std::uint32_t> suspects_;  ///< triangles whose side 1 may be illegal
  std::uint32_t last_ = 0;         ///< the triangle in which the next walk begins
  Steps flips_;
};

}  // namespace

Mesh delaunay(std::span<const Point> points) {
  assert(points.size() < (1U << 29));
  return Insertion(points).run();
}

}  // namespace oblast::internal::triangulation
