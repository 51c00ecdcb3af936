// Computes winding numbers with rays, and areas with sums over edges.
#include "verify/arrangement.h"

#include <algorithm>

#include "verify/edges.h"
#include "verify/predicates.h"
#include "verify/slabs.h"

namespace oblast::verify {
namespace {

std::vector<Point> ends_of(const std::vector<NodedEdge>& edges) {
  std::vector<Point> ends;
  for (const NodedEdge& e : edges) ends.insert(ends.end(), {e.from, e.to});
  return ends;
}

bool is_inside(const FillRule& rule, int winding) {
  switch (rule.kind) {
    case FillRule::Kind::polygons:
    case FillRule::Kind::positive:
      return winding > 0;
    case FillRule::Kind::at_least:
      return winding >= rule.depth;
    case FillRule::Kind::even_odd:
      return winding % 2 != 0;
    case FillRule::Kind::nonzero:
      return winding != 0;
    case FillRule::Kind::negative:
      return winding < 0;
  }
  return false;
}

/// True if the ray downwards from `middle`, moved to the right by an infinitesimal amount, meets the edge from p to q.
/// All points are in half units.
bool is_below(const ScaledPoint& p, const ScaledPoint& q, const ScaledPoint& middle) {
  const auto& [low, high] = p.x < q.x ? std::tie(p, q) : std::tie(q, p);
  if (middle.x < low.x || middle.x >= high.x) return false;
  if (middle.y < std::min(p.y, q.y)) return false;
  if (middle.y > std::max(p.y, q.y)) return true;
  return determinant(low, high, middle).sign() > 0;
}

ScaledPoint twice(const ScaledPoint& p) { return {p.x + p.x, p.y + p.y}; }

}  // namespace

NodedArrangement::NodedArrangement(std::vector<NodedEdge> edges, const FillRule& rule_a, const FillRule& rule_b)
    : edges_(std::move(edges)), rule_a_(rule_a), rule_b_(rule_b), scale_(ends_of(edges_)) {
  for (const NodedEdge& e : edges_) {
    from_.push_back(twice(scale_(e.from)));
    to_.push_back(twice(scale_(e.to)));
  }
}

std::optional<Fault> NodedArrangement::check_settled() const {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    for (std::size_t f = 0; f < e; ++f) {
      const auto& [a, b] = std::tie(edges_[e].from, edges_[e].to);
      const auto& [c, d] = std::tie(edges_[f].from, edges_[f].to);
      if (!meet_badly(a, b, c, d)) continue;
      return Fault{"noded edges " + to_text(a) + " -> " + to_text(b) + " and " + to_text(c) + " -> " + to_text(d) +
                       " meet elsewhere than at a common end",
                   {}};
    }
  }
  return std::nullopt;
}

//   ^ y      left side, if e runs to the right      For a vertical edge the ray starts just right of it,
//   |    from ----- middle ----> to                 and does not meet e itself.
//   |                  | The ray: the sum of the changes
//   +                  v below it is the winding number below e.
NodedArrangement::Sides NodedArrangement::sides_of(std::size_t e) const {
  // Both ends are even numbers of half units, so the midpoint is exact.
  const ScaledPoint middle{(from_[e].x + to_[e].x) / 2, (from_[e].y + to_[e].y) / 2};
  int a = 0, b = 0;
  for (std::size_t f = 0; f < edges_.size(); ++f) {
    if (f == e || !is_below(from_[f], to_[f], middle)) continue;
    const int sign = from_[f].x < to_[f].x ? 1 : -1;
    a += sign * edges_[f].change_a;
    b += sign * edges_[f].change_b;
  }
  const bool vertical = from_[e].x == to_[e].x;
  const bool seen_is_right = vertical ? from_[e].y < to_[e].y : from_[e].x < to_[e].x;
  const int right_a = seen_is_right ? a : a - edges_[e].change_a;
  const int right_b = seen_is_right ? b : b - edges_[e].change_b;
  return {is_inside(rule_a_, right_a + edges_[e].change_a), is_inside(rule_a_, right_a),
          is_inside(rule_b_, right_b + edges_[e].change_b), is_inside(rule_b_, right_b)};
}

NodedArrangement::Areas NodedArrangement::twice_areas() const {
  Areas areas;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Sides s = sides_of(e);
    const ScaledPoint p = scale_(edges_[e].from), q = scale_(edges_[e].to);
    const WideInteger swept = p.x * q.y - q.x * p.y;
    // An edge bounds a region if the region is on exactly one side of it. If this is the left side, the edge runs
    // forward.
    const auto add = [&](WideInteger& area, bool left, bool right) {
      if (left && !right) area += swept;
      if (right && !left) area -= swept;
    };
    add(areas.a, s.a_left, s.a_right);
    add(areas.b, s.b_left, s.b_right);
    for (int o = 0; o < 4; ++o) {
      const auto operation = static_cast<Operation>(o);
      add(areas.by_operation[o], selects(operation, s.a_left, s.b_left), selects(operation, s.a_right, s.b_right));
    }
  }
  return areas;
}

WideInteger NodedArrangement::twice_area_of(std::span<const Point> contour) const {
  WideInteger area = 0;
  for (std::size_t v = 0; v < contour.size(); ++v) {
    const ScaledPoint p = scale_(contour[v]), q = scale_(contour[(v + 1) % contour.size()]);
    area += p.x * q.y - q.x * p.y;
  }
  return area;
}

}  // namespace oblast::verify
