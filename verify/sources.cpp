// The input edges that a result is made of: exact questions of distance and origin.
#include "verify/sources.h"

#include <algorithm>
#include <cmath>

#include "verify/predicates.h"

namespace oblast::verify {

Sources::Sources(const RegionView& a, const RegionView& b, double bound_ulps) {
  double largest = 0;
  for (const RegionView& regions : {a, b}) {
    for (std::size_t c = 0; c < regions.contour_count(); ++c) {
      const auto contour = regions.contour(c);
      for (std::size_t v = 0; v < contour.size(); ++v) {
        const Point from = contour[v], to = contour[(v + 1) % contour.size()];
        largest = std::max({largest, std::abs(from.x), std::abs(from.y)});
        vertices_.push_back(from);
        if (from != to) edges_.push_back({from, to});
      }
    }
  }
  std::sort(vertices_.begin(), vertices_.end(), lexicographically_less);
  unit_ = std::nextafter(largest, HUGE_VAL) - largest;
  bound_ = bound_ulps * unit_;
  squared_bound_ = Rational(bound_) * Rational(bound_);
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
      if (meeting && round_to_nearest(meeting->x) == p.x && round_to_nearest(meeting->y) == p.y) return true;
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

bool Sources::may_have_cancelled(const Point& p) const {
  // Whether f covers the beginning of e, which starts or ends at p.
  const auto covers = [&](const InputEdge& f, const InputEdge& e) {
    const Point& far = e.from == p ? e.to : e.from;
    if (f.from == p || f.to == p) return same_direction(p, far, f.from == p ? f.to : f.from);
    if (side_of_line(f.from, f.to, p) != 0 || side_of_line(f.from, f.to, far) != 0) return false;
    return std::min(f.from.x, f.to.x) <= p.x && p.x <= std::max(f.from.x, f.to.x) &&
           std::min(f.from.y, f.to.y) <= p.y && p.y <= std::max(f.from.y, f.to.y);
  };
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].from != p && edges_[i].to != p) continue;
    bool covered = false;
    for (std::size_t j = 0; j < edges_.size() && !covered; ++j) covered = j != i && covers(edges_[j], edges_[i]);
    if (!covered) return false;
  }
  return true;
}

}  // namespace oblast::verify
