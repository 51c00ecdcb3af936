#include "triangulation/growing_delaunay.h"

#include <algorithm>
#include <cassert>

#include "base/large_pages.h"
#include "exact/in_circle.h"
#include "exact/orientation.h"
#include "triangulation/locate.h"
#include "triangulation/spatial_order.h"

namespace oblast::internal::triangulation {

using exact::in_circle;
using exact::orientation;

bool GrowingDelaunay::add(std::span<const Point> points) {
  assert(given_ + points.size() < (1U << 29));
  gather(points);
  std::uint32_t next = begin_;
  if (mesh_.triangles.empty()) {
    if (!find_three()) {
      mesh_ = {};
      return false;
    }
    first_triangle();
    next = 3;
  } else {
    ++batch_;
  }
  changed_.clear();
  const auto end = static_cast<std::uint32_t>(mesh_.points.size());
  Steps steps(end - next), flips;
  for (; next < end; ++next) {
    steps();
    insert(next, flips);
  }
  mesh_.points.resize(vertices_);
  given_ += points.size();
  return true;
}

namespace {

/// Later batches are many and small, so that arrays grow by a share of their length.
template <class T>
void make_room(Array<T>& items, std::size_t count) {
  if (items.capacity() < count) reserve_in_large_pages(items, std::max(count, items.size() + items.size() / 4));
}

}  // namespace

void GrowingDelaunay::gather(std::span<const Point> points) {
  begin_ = vertices_;
  order_ = spatial_order(points);
  // The points are gathered once. Otherwise each later step would wait for memory.
  make_room(mesh_.points, begin_ + points.size());
  for (const std::uint32_t index : order_) mesh_.points.push_back(points[index]);
  make_room(mesh_.vertex_of, given_ + points.size());
  mesh_.vertex_of.resize(given_ + points.size());
  make_room(mesh_.triangles, 2 * (begin_ + points.size()));
}

/// Makes the point at place `i` a vertex. Equal points become one vertex.
std::uint32_t GrowingDelaunay::add_vertex(std::uint32_t i) {
  mesh_.points[vertices_] = mesh_.points[i];
  mesh_.vertex_of[given_ + order_[i - begin_]] = vertices_;
  return vertices_++;
}

void GrowingDelaunay::swap_places(std::size_t i, std::size_t j) {
  std::swap(order_[i], order_[j]);
  std::swap(mesh_.points[i], mesh_.points[j]);
}

/// Moves three points of the first batch that are not collinear to its front. False if there are none.
bool GrowingDelaunay::find_three() {
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

void GrowingDelaunay::first_triangle() {
  const std::uint32_t a = add_vertex(0), b = add_vertex(1), c = add_vertex(2);
  // Triangle 0, and the ghosts 1, 2, 3 beyond its sides 0, 1, 2.
  mesh_.triangles.push_back({{a, b, c}, 0, {half_edge(1, 0), half_edge(2, 0), half_edge(3, 0)}, 0});
  mesh_.triangles.push_back({{b, a, infinite_vertex}, 0, {half_edge(0, 0), half_edge(3, 2), half_edge(2, 1)}, 0});
  mesh_.triangles.push_back({{c, b, infinite_vertex}, 0, {half_edge(0, 1), half_edge(1, 2), half_edge(3, 1)}, 0});
  mesh_.triangles.push_back({{a, c, infinite_vertex}, 0, {half_edge(0, 2), half_edge(2, 2), half_edge(1, 1)}, 0});
}

/// Triangle::mark is twice the number of the last batch that changed the triangle or one beside it, plus 1 if it did so
/// to the triangle itself. The first batch leaves 0.
void GrowingDelaunay::note_changed(std::uint32_t t) {
  std::uint32_t& mark = mesh_.triangles[t].mark;
  if (batch_ == 0 || mark == (batch_ << 1 | 1)) return;
  mark = batch_ << 1 | 1;
  changed_.push_back(t);
}

/// h is a side of a triangle that stays, beside one that changes.
void GrowingDelaunay::set_outer_twin(HalfEdge h, HalfEdge twin) {
  mesh_.set_twin(h, twin);
  touch(triangle_of(h));
}

void GrowingDelaunay::touch(std::uint32_t triangle) {
  std::uint32_t& mark = mesh_.triangles[triangle].mark;
  mark = std::max(mark, batch_ << 1);
}

void GrowingDelaunay::insert(std::uint32_t i, Steps& flips) {
  const Place place = locate(mesh_, last_, mesh_.points[i]);
  if (place.kind == Place::Kind::at_vertex) {
    mesh_.vertex_of[given_ + order_[i - begin_]] = mesh_.origin(place.half_edge);
    last_ = triangle_of(place.half_edge);
    return;
  }
  const std::uint32_t v = add_vertex(i);
  if (place.kind == Place::Kind::inside)
    part_triangle(triangle_of(place.half_edge), v);
  else
    part_side(place.half_edge, v);
  flip_illegal(v, flips);
}

std::uint32_t GrowingDelaunay::add_triangle() {
  mesh_.triangles.push_back({});
  return static_cast<std::uint32_t>(mesh_.triangles.size() - 1);
}

/// Makes the triangle (p, a, b) with p as vertex 0. Its side 1 will be tested. The caller sets the twins of sides 0
/// and 2.
void GrowingDelaunay::make(std::uint32_t t, std::uint32_t p, std::uint32_t a, std::uint32_t b, HalfEdge beyond) {
  Triangle& made = mesh_.triangles[t];
  made.vertex[0] = p;
  made.vertex[1] = a;
  made.vertex[2] = b;
  made.twin[1] = beyond;
  note_changed(t);
  set_outer_twin(beyond, half_edge(t, 1));
  suspects_.push_back(t);
}

/// Makes side 2 of `before` and side 0 of `after` twins.
void GrowingDelaunay::join_around(std::uint32_t before, std::uint32_t after) {
  mesh_.triangles[before].twin[2] = half_edge(after, 0);
  mesh_.triangles[after].twin[0] = half_edge(before, 2);
}

///        c
///       /|\          three triangles with p at vertex 0, one for each side
///      / p \         .
///     a --- b
void GrowingDelaunay::part_triangle(std::uint32_t t, std::uint32_t p) {
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
void GrowingDelaunay::part_side(HalfEdge h, std::uint32_t p) {
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

/// True if c is inside the circle of t = (p, a, b). The circle of a ghost is the half-plane beyond its side of the
/// hull.
inline bool GrowingDelaunay::is_illegal(const Triangle& t, std::uint32_t p, std::uint32_t c) const {
  const std::uint32_t a = t.vertex[1], b = t.vertex[2];
  const auto& points = mesh_.points;
  if (((a | b | c) >> 31) == 0) return in_circle(points[p], points[a], points[b], points[c]) > 0;
  if (c == infinite_vertex) return false;
  // t and its neighbour are ghosts with the sides (b, p) and (c, b), or (p, a) and (a, c). p may see the side of the
  // neighbour, too.
  if (a == infinite_vertex) return orientation(points[c], points[b], points[p]) > 0;
  return orientation(points[a], points[c], points[p]) > 0;
}

/// Lawson's flips. All suspects have the new point p at vertex 0:
///
///        b                   b
///      / | \               / u \      t = (p, a, b) and u = (b, a, c) become
///    p t | u c    ->     p ----- c    t = (p, a, c) and u = (p, c, b)
///      \ | /               \ t /      .
///        a                   a
void GrowingDelaunay::flip_illegal(std::uint32_t p, Steps& flips) {
  std::uint32_t t = 0;
  while (!suspects_.empty()) {
    flips();
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
      note_changed(u);
      set_outer_twin(cb, half_edge(u, 1));
      mesh_.set_twin(after, half_edge(u, 2));
      low.vertex[2] = c;
      low.twin[1] = ac;
      low.twin[2] = half_edge(u, 0);
      set_outer_twin(ac, half_edge(t, 1));
      suspects_.push_back(u);
    }
  }
  last_ = t;
}

}  // namespace oblast::internal::triangulation
