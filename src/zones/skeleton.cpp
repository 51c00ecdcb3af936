#include "zones/skeleton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/orientation.h"
#include "plane/largest_ulp.h"
#include "triangulation/constrain.h"
#include "triangulation/delaunay.h"
#include "zones/distance.h"
#include "zones/vertices_on_edges.h"

namespace oblast::internal::zoning {
namespace {

using namespace triangulation;

/// The least radius of a contact, in units: what is nearer together is not told apart.
constexpr double least_radius = 16;

/// A strip is so high, in units, that noding does not close it; nor an overlap of polygons.
constexpr double least_height = 8;

/// How many thin triangles a strip passes at most, and how many are passed to find an overlap.
constexpr int deepest_strip = 8;

class Finder {
 public:
  Finder(const SettledObjects& settled, const Room& room) : settled_(settled), room_(room) {}

  Skeleton run() {
    triangulate();
    cover_triangles();
    find_free_edges();
    find_contacts();
    add_points();
    return std::move(skeleton_);
  }

 private:
  /// A piece of a settled edge: all of it, but where it passes through points.
  struct Piece {
    std::uint32_t edge, low, high;  ///< the ends are vertices
  };

  void triangulate() {
    LargeArray<Point> points;
    const std::size_t count = 2 * settled_.edges.size() + settled_.points.size() + room_.ring.size();
    check_count(count, "vertices of objects", most_mesh_vertices);
    points.reserve(count);
    for (const SettledEdge& edge : settled_.edges) {
      points.push_back(edge.low);
      points.push_back(edge.high);
    }
    for (const LonePoint& point : settled_.points) points.push_back(point.at);
    points.insert(points.end(), room_.ring.begin(), room_.ring.end());
    mesh_ = delaunay(points);
    Array<std::uint32_t> on_edge;
    VerticesOnEdges find(mesh_);
    for (std::uint32_t e = 0; e < settled_.edges.size(); ++e) {
      std::uint32_t low = mesh_.vertex_of[2 * e];
      const std::uint32_t high = mesh_.vertex_of[2 * e + 1];
      on_edge.clear();
      // Ends of other edges are not on this one, since edges are settled.
      if (!settled_.points.empty()) find.between(low, high, on_edge);
      on_edge.push_back(high);
      for (const std::uint32_t v : on_edge) {
        pieces_.push_back({e, low, v});
        low = v;
      }
    }
    Array<Constraint> constraints(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) constraints[i] = {pieces_[i].low, pieces_[i].high};
    half_edges_ = constrain(mesh_, constraints);
    is_constrained_.assign(4 * mesh_.triangles.size(), false);
    for (const HalfEdge h : half_edges_) is_constrained_[h] = is_constrained_[mesh_.twin(h)] = true;
  }

  /// By triangle: how many polygons cover it. Everything is reached from the outside, side by side.
  void cover_triangles() {
    Array<std::uint32_t> piece_of(4 * mesh_.triangles.size(), none);
    for (std::uint32_t k = 0; k < half_edges_.size(); ++k)
      piece_of[half_edges_[k]] = piece_of[mesh_.twin(half_edges_[k])] = k;
    cover_.assign(mesh_.triangles.size(), unknown);
    Array<std::uint32_t> waiting;
    for (std::uint32_t t = 0; t < mesh_.triangles.size() && waiting.empty(); ++t)
      if (mesh_.triangles[t].is_ghost()) {
        cover_[t] = 0;
        waiting.push_back(t);
      }
    Steps steps(mesh_.triangles.size());
    while (!waiting.empty()) {
      steps();
      const std::uint32_t t = waiting.back();
      waiting.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge h = half_edge(t, i), g = mesh_.twin(h);
        const std::uint32_t across = triangle_of(g), k = piece_of[h];
        if (cover_[across] != unknown) continue;
        std::int32_t change = 0;
        if (k != none) change = settled_.edges[pieces_[k].edge].cover * (half_edges_[k] == h ? -1 : 1);
        cover_[across] = cover_[t] + change;
        waiting.push_back(across);
      }
    }
  }

  void find_free_edges() {
    owner_.assign(mesh_.points.size(), none);
    contact_.assign(mesh_.points.size(), none);
    on_edge_.assign(mesh_.points.size(), false);
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      const auto [e, low, high] = pieces_[k];
      const SettledEdge& edge = settled_.edges[e];
      on_edge_[low] = on_edge_[high] = true;
      const HalfEdge h = half_edges_[k];
      if (is_covered(h) && is_covered(mesh_.twin(h)) && !may_open(h) && !may_open(mesh_.twin(h))) continue;
      const std::uint32_t object = std::min(edge.outline_of, edge.line_of);
      skeleton_.edges.push_back({mesh_.points[low], mesh_.points[high], object, none, none, low, high});
      append_strip(h);
      for (const std::uint32_t v : {low, high}) {
        if (owner_[v] != none && owner_[v] != object) contact_[v] = is_contact;
        owner_[v] = std::min(owner_[v], object);
      }
    }
  }

  /// Whether polygons cover the triangle on the left of a side.
  bool is_covered(HalfEdge h) const { return cover_[triangle_of(h)] > 0; }

  /// Whether noding may open a gap at an edge: on its left two polygons overlap, so little that their edges may change
  /// places. Between the edges there would be as many polygons as on both sides less those of the overlap.
  ///
  ///      A         A           the edge of A and that of B, numbers of polygons beside them
  ///     ___ B     === A      1                  1
  ///     === A     ___ B      2 in the overlap   0 where they have changed places
  ///      B         B         1                  1
  bool may_open(HalfEdge h) const {
    const std::int32_t more = cover_[triangle_of(h)] - cover_[triangle_of(mesh_.twin(h))];
    return more > 0 && is_thin_up_to(h, mesh_.points[mesh_.origin(h)], mesh_.points[mesh_.target(h)], more, 0);
  }

  /// Whether thin triangles on the left of a side lead to one that at most so many polygons cover.
  bool is_thin_up_to(HalfEdge h, const Point& from, const Point& to, std::int32_t polygons, int depth) const {
    if (mesh_.triangles[triangle_of(h)].is_ghost()) return false;
    if (distance_from_segment(mesh_.points[mesh_.apex(h)], from, to) > least_height * room_.unit) return false;
    for (const HalfEdge side : {next(h), previous(h)}) {
      const HalfEdge behind = mesh_.twin(side);
      if (cover_[triangle_of(behind)] <= polygons) return true;
      if (depth < deepest_strip && is_thin_up_to(behind, from, to, polygons, depth + 1)) return true;
    }
    return false;
  }

  /// Appends the top of the strip along a part of a side, on its left, from `to` to `from`, without these. Where the
  /// triangle there is too thin, the strip goes on behind it, if no edge is in the way.
  void append_top(HalfEdge h, const Point& from, const Point& to, int depth, Array<Point>& top) const {
    const std::uint32_t t = triangle_of(h);
    if (cover_[t] > 0 || mesh_.triangles[t].is_ghost()) return;
    const Point &a = mesh_.points[mesh_.origin(h)], &b = mesh_.points[mesh_.target(h)],
                &c = mesh_.points[mesh_.apex(h)];
    const Point middle{a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3};
    const double part = std::min(0.5, room_.tolerance / 16 / distance_from_segment(middle, from, to));
    const auto towards_middle = [&](const Point& p) {
      return Point{in_domain_near(p.x + part * (middle.x - p.x)), in_domain_near(p.y + part * (middle.y - p.y))};
    };
    const auto has_room = [&](const Point& p) {
      return distance_from_segment(p, a, b) >= least_height * room_.unit && exact::orientation(a, b, p) > 0 &&
             exact::orientation(b, c, p) > 0 && exact::orientation(c, a, p) > 0;
    };
    const Point first = towards_middle(from), second = towards_middle(to);
    if (has_room(first) && has_room(second)) {
      top.push_back(second);
      if (first != second) top.push_back(first);
    } else if (depth < deepest_strip) {
      const double x = to.x - from.x, y = to.y - from.y, along = (c.x - from.x) * x + (c.y - from.y) * y;
      if (along <= 0) {
        append_top_behind(next(h), from, to, depth, top);
      } else if (along >= x * x + y * y) {
        append_top_behind(previous(h), from, to, depth, top);
      } else if (distance_from_segment(c, from, to) <= 4 * least_height * room_.unit) {
        append_top_behind(next(h), c, to, depth, top);
        top.push_back(c);
        append_top_behind(previous(h), from, c, depth, top);
      }
    }
  }

  void append_top_behind(HalfEdge side, const Point& from, const Point& to, int depth, Array<Point>& top) const {
    if (!is_constrained_[side]) append_top(mesh_.twin(side), from, to, depth + 1, top);
  }

  void append_strip(HalfEdge h) {
    const Point &low = mesh_.points[mesh_.origin(h)], &high = mesh_.points[mesh_.target(h)];
    append_top(mesh_.twin(h), high, low, 0, skeleton_.strips.tops);
    skeleton_.strips.ends.push_back(skeleton_.strips.tops.size());
    append_top(h, low, high, 0, skeleton_.strips.tops);
    skeleton_.strips.ends.push_back(skeleton_.strips.tops.size());
  }

  void find_contacts() {
    Array<HalfEdge> leaving(mesh_.points.size(), none);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::uint32_t i = 0; i < 3; ++i)
        if (const std::uint32_t v = mesh_.triangles[t].vertex[i]; v != infinite_vertex) leaving[v] = half_edge(t, i);
    const auto contact_at = [&](std::uint32_t v) {
      if (contact_[v] == none) return none;
      if (contact_[v] == is_contact) contact_[v] = make_contact(v, leaving[v]);
      return contact_[v];
    };
    for (FreeEdge& edge : skeleton_.edges) {
      edge.low_contact = contact_at(edge.low_vertex);
      edge.high_contact = contact_at(edge.high_vertex);
    }
    skeleton_.object_of_vertex = std::move(owner_);
  }

  std::uint32_t make_contact(std::uint32_t v, HalfEdge leaving) {
    const Point at = mesh_.points[v];
    double nearest = 4 * room_.sampling;
    HalfEdge h = leaving;
    do {
      const std::uint32_t p = mesh_.target(h), q = mesh_.apex(h);
      if (p != infinite_vertex && q != infinite_vertex)
        nearest = std::min(nearest, distance_from_segment(at, mesh_.points[p], mesh_.points[q]));
      h = mesh_.clockwise(h);
    } while (h != leaving);
    const double radius = std::ldexp(1.0, std::ilogb(std::max(nearest / 4, least_radius * room_.unit)));
    skeleton_.contacts.push_back({at, radius});
    return static_cast<std::uint32_t>(skeleton_.contacts.size() - 1);
  }

  void add_points() {
    Array<bool> covered(mesh_.points.size(), false);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      if (cover_[t] > 0)
        for (const std::uint32_t v : mesh_.triangles[t].vertex) covered[v] = true;
    for (std::size_t i = 0; i < settled_.points.size(); ++i) {
      const std::uint32_t v = mesh_.vertex_of[2 * settled_.edges.size() + i];
      if (!on_edge_[v] && !covered[v]) skeleton_.points.push_back(settled_.points[i]);
    }
  }

  static constexpr std::int32_t unknown = -0x7fffffff;
  static constexpr std::uint32_t is_contact = none - 1;

  const SettledObjects& settled_;
  const Room& room_;
  Mesh mesh_;
  Array<Piece> pieces_;
  Array<HalfEdge> half_edges_;            ///< by piece: from low to high
  Array<bool> is_constrained_;            ///< by half-edge
  Array<std::int32_t> cover_;             ///< by triangle
  Array<std::uint32_t> owner_, contact_;  ///< by vertex
  Array<bool> on_edge_;                   ///< by vertex
  Skeleton skeleton_;
};

}  // namespace

Skeleton find_skeleton(const SettledObjects& settled, const Room& room) {
  if (!settled.edges.empty()) return Finder(settled, room).run();
  Skeleton skeleton;
  skeleton.points = settled.points;
  return skeleton;
}

}  // namespace oblast::internal::zoning
