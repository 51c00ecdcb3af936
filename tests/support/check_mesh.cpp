#include "support/check_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "support/exact_signs.h"

namespace oblast::testing {
namespace {

using namespace triangulation;
using Side = std::pair<std::uint32_t, std::uint32_t>;
using Fault = std::optional<std::string>;

std::string at(const char* what, std::uint32_t index) { return what + std::string(" at ") + std::to_string(index); }

Fault check_topology(const Mesh& m) {
  std::vector<bool> used(m.points.size(), false);
  for (std::uint32_t t = 0; t < m.triangles.size(); ++t) {
    if (m.triangles[t].mark != 0) return at("a mark left behind", t);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge h = half_edge(t, i), g = m.twin(h);
      if (triangle_of(g) >= m.triangles.size() || side_of(g) > 2) return at("twin out of range", h);
      if (m.twin(g) != h) return at("twins not mutual", h);
      if (m.origin(h) != m.target(g) || m.target(h) != m.origin(g)) return at("twins of different sides", h);
      if (m.is_constrained(h) != m.is_constrained(g)) return at("marks of a constraint differ", h);
      if (m.origin(h) != infinite_vertex) used[m.origin(h)] = true;
    }
  }
  if (!m.triangles.empty() && m.triangles.size() != 2 * m.points.size() - 2) return "wrong number of triangles";
  if (!m.triangles.empty() && std::find(used.begin(), used.end(), false) != used.end())
    return "a vertex without triangle";
  return {};
}

Fault check_geometry(const Mesh& m) {
  const auto points = to_integers(m.points);
  Integer area = 0, hull_area = 0;
  for (std::uint32_t t = 0; t < m.triangles.size(); ++t) {
    const Triangle& triangle = m.triangles[t];
    if (triangle.is_ghost()) {
      HalfEdge hull = half_edge(t, 0);
      while (m.apex(hull) != infinite_vertex) hull = next(hull);
      // Clockwise along the hull: the next ghost's side must not turn left.
      const HalfEdge after = next(m.twin(next(hull)));
      const std::uint32_t a = m.origin(hull), b = m.target(hull), c = m.target(after);
      if (m.origin(after) != b) return at("ghosts out of order", t);
      if (exact_orientation(m.points[a], m.points[b], m.points[c]) > 0) return at("the hull is not convex", t);
      hull_area += points[b].x * points[a].y - points[a].x * points[b].y;
    } else {
      const auto& v = triangle.vertex;
      const Integer doubled = doubled_area(points[v[0]], points[v[1]], points[v[2]]);
      if (doubled <= 0) return at("a triangle does not turn left", t);
      area += doubled;
    }
  }
  if (area != hull_area) return "areas do not sum up to the hull's";
  return {};
}

Fault check_delaunay(const Mesh& m) {
  for (std::uint32_t t = 0; t < m.triangles.size(); ++t) {
    if (m.triangles[t].is_ghost()) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge h = half_edge(t, i), g = m.twin(h);
      if (h < g || m.is_constrained(h) || m.triangles[triangle_of(g)].is_ghost()) continue;
      const auto& v = m.triangles[t].vertex;
      if (exact_in_circle(m.points[v[0]], m.points[v[1]], m.points[v[2]], m.points[m.apex(g)]) > 0)
        return at("a side is not Delaunay", h);
    }
  }
  return {};
}

Fault check_constraints(const Mesh& m, std::span<const Constraint> constraints) {
  std::vector<Side> wanted, found;
  for (const Constraint& c : constraints) {
    wanted.push_back({c.from, c.to});
    wanted.push_back({c.to, c.from});
  }
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  for (std::uint32_t t = 0; t < m.triangles.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i)
      if (m.is_constrained(half_edge(t, i))) found.push_back({m.origin(half_edge(t, i)), m.target(half_edge(t, i))});
  std::sort(found.begin(), found.end());
  if (found != wanted) return "the sides marked are not the constraints";
  return {};
}

Integer doubled_area(const RegionSet& regions, const std::vector<IntegerPoint>& points, std::uint32_t polygon) {
  const RegionView view = regions;
  Integer sum = 0;
  for (std::uint32_t c = view.polygon_begin(polygon); c < view.polygon_end(polygon); ++c) {
    const std::uint32_t begin = view.contour_begin(c), end = view.contour_end(c);
    for (std::uint32_t i = begin; i < end; ++i) {
      const IntegerPoint &p = points[i], &q = points[i + 1 == end ? begin : i + 1];
      sum += p.x * q.y - q.x * p.y;
    }
  }
  return sum;
}

/// The public arrays as a mesh, with ghosts, for the same checks.
Mesh to_mesh(const Triangulation& t) {
  Mesh m;
  m.points.assign(t.points.begin(), t.points.end());
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    Triangle triangle{{t.triangles[i][0], t.triangles[i][1], t.triangles[i][2]}, 0, {none, none, none}, 0};
    for (std::uint32_t s = 0; s < 3; ++s) triangle.constrained |= (t.is_side[i][s] ? 1U : 0U) << s;
    m.triangles.push_back(triangle);
  }
  std::vector<HalfEdge> ghost_at(t.points.size(),
                                 none);  // by hull vertex: the ghost side that leaves it for infinity
  const auto real = static_cast<std::uint32_t>(t.triangles.size());
  for (std::uint32_t i = 0; i < real; ++i) {
    for (std::uint32_t s = 0; s < 3; ++s) {
      const std::uint32_t beyond = t.neighbours[i][s], a = t.triangles[i][s], b = t.triangles[i][(s + 1) % 3];
      if (beyond != Triangulation::none) {
        for (std::uint32_t r = 0; r < 3; ++r)
          if (t.triangles[beyond][r] == b && t.triangles[beyond][(r + 1) % 3] == a)
            m.triangles[i].twin[s] = half_edge(beyond, r);
        continue;
      }
      const auto ghost = static_cast<std::uint32_t>(m.triangles.size());
      m.triangles.push_back(
          {{b, a, infinite_vertex}, (m.triangles[i].constrained >> s) & 1, {half_edge(i, s), 0, 0}, 0});
      m.triangles[i].twin[s] = half_edge(ghost, 0);
      ghost_at[a] = half_edge(ghost, 1);
    }
  }
  for (std::uint32_t g = real; g < m.triangles.size(); ++g) {
    const HalfEdge arriving = half_edge(g, 2);  // from infinity to vertex 0
    m.join(arriving, ghost_at[m.triangles[g].vertex[0]]);
  }
  return m;
}

}  // namespace

Fault check_mesh(const Mesh& mesh, std::span<const Constraint> constraints) {
  if (auto fault = check_topology(mesh)) return fault;
  if (mesh.triangles.empty()) return {};
  if (auto fault = check_geometry(mesh)) return fault;
  if (auto fault = check_delaunay(mesh)) return fault;
  return check_constraints(mesh, constraints);
}

Fault check_triangulation(const Triangulation& t) {
  std::vector<Constraint> sides;
  const RegionView view = t.regions;
  std::vector<std::uint32_t> by_place(t.points.size());
  std::iota(by_place.begin(), by_place.end(), 0U);
  std::sort(by_place.begin(), by_place.end(),
            [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(t.points[i], t.points[j]); });
  const auto number = [&](const Point& p) {
    return *std::lower_bound(by_place.begin(), by_place.end(), p,
                             [&](std::uint32_t i, const Point& q) { return lexicographically_less(t.points[i], q); });
  };
  for (std::uint32_t c = 0; c < view.contour_count(); ++c) {
    const auto contour = view.contour(c);
    for (std::size_t i = 0; i < contour.size(); ++i)
      sides.push_back({number(contour[i]), number(contour[(i + 1) % contour.size()])});
  }
  if (auto fault = check_mesh(to_mesh(t), sides)) return fault;

  std::vector<Point> all = t.points;
  all.insert(all.end(), t.regions.points.begin(), t.regions.points.end());
  std::vector<IntegerPoint> vertices = to_integers(all);
  const std::vector<IntegerPoint> contour_points(vertices.begin() + static_cast<std::ptrdiff_t>(t.points.size()),
                                                 vertices.end());
  std::vector<Integer> area(view.polygon_count());
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    if (t.polygon[i] == Triangulation::none) continue;
    const auto& v = t.triangles[i];
    area[t.polygon[i]] += doubled_area(vertices[v[0]], vertices[v[1]], vertices[v[2]]);
  }
  for (std::uint32_t p = 0; p < area.size(); ++p)
    if (area[p] != doubled_area(t.regions, contour_points, p)) return at("area of a polygon", p);
  return {};
}

}  // namespace oblast::testing
