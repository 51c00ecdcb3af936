// The input edges that a result is made of: exact questions of distance and origin.
#include "verify/sources.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

#include "verify/predicates.h"

namespace oblast::verify {

Sources::Sources(const RegionView& a, const RegionView& b, const Options& options, double bound_ulps) {
  collect(a, options.fill_a.by_polygon(), 0);
  collect(b, options.fill_b.by_polygon(), a.polygon_count());
  double largest = 0;
  for (const Point& p : vertices_) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  std::sort(vertices_.begin(), vertices_.end(), lexicographically_less);
  // A crossing is put into the domain, which moves it by up to half its smallest magnitude.
  unit_ = std::max(std::nextafter(largest, HUGE_VAL) - largest, domain_smallest);
  bound_ = bound_ulps * unit_;
  squared_bound_ = Rational(bound_) * Rational(bound_);
}

void Sources::collect(const RegionView& regions, bool by_polygon, std::size_t first_polygon) {
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
      const auto contour = regions.contour(c);
      for (std::size_t v = 0; v < contour.size(); ++v) {
        const Point from = contour[v], to = contour[(v + 1) % contour.size()];
        vertices_.push_back(from);
        if (from != to) edges_.push_back({from, to, by_polygon ? first_polygon + p : InputEdge::npos});
      }
    }
  }
}

bool Sources::is_vertex(const Point& p) const {
  return std::binary_search(vertices_.begin(), vertices_.end(), p, lexicographically_less);
}

bool Sources::is_rounded_intersection(const Point& p) const {
  // Both edges pass p within a unit in the last place, so only pairs of near edges are tried.
  std::vector<std::size_t> close;
  const RationalPoint at(p);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (near(at, edges_[e])) close.push_back(e);
  }
  for (std::size_t i = 0; i < close.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const InputEdge &e = edges_[close[i]], &f = edges_[close[j]];
      const auto meeting = intersection_of_segments(e.from, e.to, f.from, f.to);
      if (meeting && round_into_domain(meeting->x) == p.x && round_into_domain(meeting->y) == p.y) return true;
    }
  }
  return false;
}

bool Sources::near(const RationalPoint& p, const InputEdge& edge) const {
  // Far away in one coordinate? Doubles decide, with room to spare.
  const double x = static_cast<double>(p.x), y = static_cast<double>(p.y), margin = 2 * bound_;
  if (x < std::min(edge.from.x, edge.to.x) - margin || x > std::max(edge.from.x, edge.to.x) + margin) return false;
  if (y < std::min(edge.from.y, edge.to.y) - margin || y > std::max(edge.from.y, edge.to.y) + margin) return false;
  return squared_distance(p, edge.from, edge.to) <= squared_bound_;
}

bool Sources::near_any(const RationalPoint& p) const {
  return std::any_of(edges_.begin(), edges_.end(), [&](const InputEdge& e) { return near(p, e); });
}

std::vector<std::size_t> Sources::near_both(const Point& p, const Point& q) const {
  std::vector<std::size_t> found;
  const RationalPoint one(p), other(q);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (near(one, edges_[e]) && near(other, edges_[e])) found.push_back(e);
  }
  return found;
}

bool Sources::may_be_resolved(const Point& p) const {
  std::vector<std::size_t> polygons;
  for (const std::size_t e : near_both(p, p)) {
    const std::size_t polygon = edges_[e].polygon;
    if (polygon == InputEdge::npos) continue;
    if (std::count(polygons.begin(), polygons.end(), polygon) > 0) return true;
    polygons.push_back(polygon);
  }
  return false;
}

double Sources::displacement_ulps(const Point& p) const {
  if (edges_.empty() || is_vertex(p)) return 0;
  const RationalPoint at(p);
  Rational least = squared_distance(at, edges_[0].from, edges_[0].to);
  for (const InputEdge& e : edges_) {
    const Rational distance = squared_distance(at, e.from, e.to);
    if (distance < least) least = distance;
  }
  return std::sqrt(static_cast<double>(least / (Rational(unit_) * Rational(unit_))));
}

namespace {

bool cross(const InputEdge& e, const InputEdge& f) {
  return side_of_line(e.from, e.to, f.from) * side_of_line(e.from, e.to, f.to) < 0 &&
         side_of_line(f.from, f.to, e.from) * side_of_line(f.from, f.to, e.to) < 0;
}

}  // namespace

bool Sources::may_have_cancelled(const Point& p) const {
  const RationalPoint at(p);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const InputEdge& e = edges_[i];
    if (e.from != p && e.to != p) continue;
    // The end of the stretch of e that is to run along another edge. An edge no longer than it has rounding errors for
    // its length: all of it may have come to lie on its neighbours.
    const RationalPoint other(e.from == p ? e.to : e.from);
    const double length = std::max(std::abs(e.to.x - e.from.x), std::abs(e.to.y - e.from.y));
    const Rational part = length > 3 * bound_ ? Rational(3 * bound_ / length) : Rational(1);
    const RationalPoint end{at.x + (other.x - at.x) * part, at.y + (other.y - at.y) * part};
    bool covered = false;
    for (std::size_t j = 0; j < edges_.size() && !covered; ++j)
      covered = j != i && (near(end, edges_[j]) || (near(at, edges_[j]) && cross(e, edges_[j])));
    if (!covered) return false;
  }
  return true;
}

bool Sources::meets_own_polygon(std::size_t edge) const {
  const InputEdge& e = edges_[edge];
  if (e.polygon == InputEdge::npos) return false;
  return std::any_of(edges_.begin(), edges_.end(), [&](const InputEdge& f) {
    return &f != &e && f.polygon == e.polygon && meet_badly(e.from, e.to, f.from, f.to);
  });
}

bool Sources::may_have_moved_onto(const Point& p, const Point& from, const Point& to) const {
  const std::vector<std::size_t> along = near_both(from, to);
  const RationalPoint at(p);
  for (const std::size_t e : along) {
    if (squared_distance(at, edges_[e].from, edges_[e].to) == 0 && !meets_own_polygon(e)) return false;
  }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const InputEdge& other = edges_[e];
    if (other.from == p || other.to == p || std::binary_search(along.begin(), along.end(), e)) continue;
    if (meet_badly(from, to, other.from, other.to)) return true;
  }
  return false;
}

}  // namespace oblast::verify
