// Exact tests of distance and origin, for the input edges of a result.
#include "verify/sources.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "verify/predicates.h"
#include "verify/rounded_intersection.h"

namespace oblast::verify {

Sources::Sources(const RegionView& a, const RegionView& b, const Options& options, double bound_ulps) {
  collect(a, options.fill_a.by_polygon(), 0);
  collect(b, options.fill_b.by_polygon(), a.polygon_count());
  double largest = 0;
  for (const Point& p : vertices_) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  std::sort(vertices_.begin(), vertices_.end(), lexicographically_less);
  // A crossing is rounded to the domain, which moves it by up to half of the smallest magnitude.
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

namespace {

// Whether p is the rounded intersection of two edges, if estimates can decide it. No, if the lines intersect more than
// a unit away. Yes, if the edges cross and the crossing is clearly rounded to p.
std::optional<bool> plainly_rounded(const Point& p, const InputEdge& e, const InputEdge& f) {
  const EstimatedPoint crossing = estimated_crossing(e.from, e.to, f.from, f.to);
  bool within = true;
  for (const auto& [estimate, c] : {std::pair(crossing.x, p.x), std::pair(crossing.y, p.y)}) {
    const double up = std::nextafter(c, HUGE_VAL) - c, down = c - std::nextafter(c, -HUGE_VAL);
    const Estimate away = estimate - Estimate(c);
    if (std::abs(away.value) - away.error > std::max(up, down) + domain_smallest) return false;
    const bool clear_of_zero = std::abs(c) >= 2 * domain_smallest;
    within = within && clear_of_zero && std::abs(away.value) + away.error < 0.499L * std::min(up, down);
  }
  if (!within || !meet_badly(e.from, e.to, f.from, f.to)) return std::nullopt;
  return true;
}

}  // namespace

bool Sources::is_rounded_intersection(const Point& p) const {
  // Both edges pass p within a unit in the last place, so only pairs of near edges are tested; those with clear answers
  // first.
  const std::vector<std::size_t> close = near_both(p, p);
  std::vector<std::pair<std::size_t, std::size_t>> unknown;
  for (std::size_t i = 0; i < close.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto plain = plainly_rounded(p, edges_[close[i]], edges_[close[j]]);
      if (plain == true) return true;
      if (!plain) unknown.push_back({close[i], close[j]});
    }
  }
  return std::any_of(unknown.begin(), unknown.end(), [&](const auto& pair) {
    const InputEdge &e = edges_[pair.first], &f = edges_[pair.second];
    return rounded_intersection(e.from, e.to, f.from, f.to) == p;
  });
}

namespace {

// True if a coordinate is, on one side, further than the bound from both ends of an edge, with a margin for rounding.
bool certainly_apart(const Estimate& c, double from, double to, double bound) {
  return c.most() < std::min(from, to) - 2 * bound || c.least() > std::max(from, to) + 2 * bound;
}

}  // namespace

Sources::Answer Sources::estimate_near(const EstimatedPoint& p, const InputEdge& edge) const {
  if (certainly_apart(p.x, edge.from.x, edge.to.x, bound_) || certainly_apart(p.y, edge.from.y, edge.to.y, bound_))
    return Answer::no;
  const Estimate dx = Estimate(edge.to.x) - Estimate(edge.from.x), dy = Estimate(edge.to.y) - Estimate(edge.from.y);
  const Estimate px = p.x - Estimate(edge.from.x), py = p.y - Estimate(edge.from.y);
  const Estimate qx = p.x - Estimate(edge.to.x), qy = p.y - Estimate(edge.to.y);
  const Estimate bound = Estimate(bound_) * Estimate(bound_);
  const Estimate to_from = px * px + py * py, to_to = qx * qx + qy * qy;
  // An end is near, so the edge is.
  if (certainly_less(to_from, bound) || certainly_less(to_to, bound)) return Answer::yes;
  const Estimate area = dx * py - dy * px, length = dx * dx + dy * dy;
  const Estimate to_line = area * area, most = bound * length;
  if (certainly_less(most, to_line)) return Answer::no;
  const Estimate along = px * dx + py * dy;
  if (along.most() < 0) return certainly_less(bound, to_from) ? Answer::no : Answer::unknown;
  if (certainly_less(length, along)) return certainly_less(bound, to_to) ? Answer::no : Answer::unknown;
  if (along.certainly_positive() && certainly_less(along, length) && certainly_less(to_line, most)) return Answer::yes;
  return Answer::unknown;
}

bool Sources::exactly_near(const RationalPoint& p, const InputEdge& edge) const {
  return squared_distance(p, edge.from, edge.to) <= squared_bound_;
}

bool Sources::near(const Point& p, const InputEdge& edge) const {
  const Answer answer = estimate_near(EstimatedPoint(p), edge);
  return answer == Answer::unknown ? exactly_near(RationalPoint(p), edge) : answer == Answer::yes;
}

bool Sources::near(const RationalPoint& p, const InputEdge& edge) const {
  const auto estimate = [](const Rational& c) {
    const auto value = static_cast<double>(c);
    return Estimate(value, std::abs(value) * std::numeric_limits<double>::epsilon());
  };
  const Answer answer = estimate_near({estimate(p.x), estimate(p.y)}, edge);
  return answer == Answer::unknown ? exactly_near(p, edge) : answer == Answer::yes;
}

bool Sources::near_any(const Trapezoid& trapezoid) const {
  const EstimatedPoint centre = trapezoid.estimated_centre();
  std::vector<const InputEdge*> unknown;
  for (const InputEdge& edge : edges_) {
    const Answer answer = estimate_near(centre, edge);
    if (answer == Answer::yes) return true;
    if (answer == Answer::unknown) unknown.push_back(&edge);
  }
  if (unknown.empty()) return false;
  const RationalPoint exactly = trapezoid.centre();
  return std::any_of(unknown.begin(), unknown.end(),
                     [&](const InputEdge* edge) { return exactly_near(exactly, *edge); });
}

std::vector<std::size_t> Sources::near_both(const Point& p, const Point& q) const {
  std::vector<std::size_t> found;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (near(p, edges_[e]) && near(q, edges_[e])) found.push_back(e);
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
  long double least = std::numeric_limits<long double>::infinity();
  for (const InputEdge& e : edges_) {
    const long double dx = static_cast<long double>(e.to.x) - e.from.x,
                      dy = static_cast<long double>(e.to.y) - e.from.y;
    const long double px = static_cast<long double>(p.x) - e.from.x, py = static_cast<long double>(p.y) - e.from.y;
    const long double length = dx * dx + dy * dy, along = px * dx + py * dy;
    const long double qx = px - dx, qy = py - dy, area = dx * py - dy * px;
    least = std::min(least, along <= 0        ? px * px + py * py
                            : along >= length ? qx * qx + qy * qy
                                              : area * area / length);
  }
  return static_cast<double>(std::sqrt(least) / unit_);
}

namespace {

/// True if the edges have a point in common, and p, an end of e, is not on f.
bool meet_beside(const Point& p, const InputEdge& e, const InputEdge& f) {
  if (side_of_line(e.from, e.to, f.from) * side_of_line(e.from, e.to, f.to) > 0) return false;
  if (side_of_line(f.from, f.to, e.from) * side_of_line(f.from, f.to, e.to) > 0) return false;
  return squared_distance(RationalPoint(p), f.from, f.to) != 0;
}

/// The end of e that is not p.
const Point& other_end(const Point& p, const InputEdge& e) { return e.from == p ? e.to : e.from; }

/// True if both edges leave p in exactly the same direction: a fold, of which the shorter edge cancels.
bool leave_together(const Point& p, const InputEdge& e, const InputEdge& f) {
  if ((e.from != p && e.to != p) || (f.from != p && f.to != p)) return false;
  const Point &u = other_end(p, e), &v = other_end(p, f);
  return side_of_line(p, u, v) == 0 && lexicographically_less(p, u) == lexicographically_less(p, v);
}

}  // namespace

RationalPoint Sources::end_of_stretch(const Point& p, const InputEdge& e) const {
  const RationalPoint at(p), other(other_end(p, e));
  const double length = std::max(std::abs(e.to.x - e.from.x), std::abs(e.to.y - e.from.y));
  const Rational part = length > 3 * bound_ ? Rational(3 * bound_ / length) : Rational(1);
  return {at.x + (other.x - at.x) * part, at.y + (other.y - at.y) * part};
}

bool Sources::may_be_flat_tip(const Point& p) const {
  return std::any_of(edges_.begin(), edges_.end(), [&](const InputEdge& f) {
    if (!near(p, f)) return false;
    // Only an edge that is resolved first can leave a point that it passes exactly.
    if (side_of_line(f.from, f.to, p) == 0 && !meets_own_polygon(f)) return false;
    const RationalPoint from(f.from), to(f.to), at(p);
    bool left = true, right = true;
    for (const InputEdge& e : edges_) {
      if (e.from != p && e.to != p) continue;
      if (near(end_of_stretch(p, e), f)) continue;  // rounding may have put it onto f
      const RationalPoint other(other_end(p, e));
      const Rational turn = (to.x - from.x) * (other.y - at.y) - (to.y - from.y) * (other.x - at.x);
      left &= turn > 0;
      right &= turn < 0;
    }
    return left || right;
  });
}

bool Sources::may_have_cancelled(const Point& p) const {
  if (may_be_flat_tip(p)) return true;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const InputEdge& e = edges_[i];
    if (e.from != p && e.to != p) continue;
    const RationalPoint end = end_of_stretch(p, e);
    bool covered = false;
    for (std::size_t j = 0; j < edges_.size() && !covered; ++j)
      covered = j != i && (near(end, edges_[j]) || (near(p, edges_[j]) && meet_beside(p, e, edges_[j])) ||
                           leave_together(p, e, edges_[j]));
    if (!covered) return false;
  }
  return true;
}

bool Sources::meets_own_polygon(const InputEdge& e) const {
  if (e.polygon == InputEdge::npos) return false;
  return std::any_of(edges_.begin(), edges_.end(), [&](const InputEdge& f) {
    return &f != &e && f.polygon == e.polygon && meet_badly(e.from, e.to, f.from, f.to);
  });
}

bool Sources::may_have_moved_onto(const Point& p, const Point& from, const Point& to) const {
  const std::vector<std::size_t> along = near_both(from, to);
  const RationalPoint at(p);
  for (const std::size_t e : along) {
    if (squared_distance(at, edges_[e].from, edges_[e].to) == 0 && !meets_own_polygon(edges_[e])) return false;
  }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const InputEdge& other = edges_[e];
    if (other.from == p || other.to == p || std::binary_search(along.begin(), along.end(), e)) continue;
    if (meet_badly(from, to, other.from, other.to)) return true;
  }
  return false;
}

}  // namespace oblast::verify
