#include "verify/zone_arrangement.h"

#include <algorithm>
#include <cmath>

#include "verify/distance.h"
#include "verify/predicates.h"
#include "verify/rows.h"

namespace oblast::verify {
namespace {

bool is_double(const Rational& value) { return Rational(round_to_nearest(value)) == value; }

bool cross(const Stroke& s, const Stroke& t) {
  if (s.a == s.b || t.a == t.b) return false;
  return side_of_line(s.a, s.b, t.a) * side_of_line(s.a, s.b, t.b) < 0 &&
         side_of_line(t.a, t.b, s.a) * side_of_line(t.a, t.b, s.b) < 0;
}

bool touches(const Stroke& s, const Stroke& t) { return has(s, t.a) || has(s, t.b) || has(t, s.a) || has(t, s.b); }

/// Within `distance` of the edge, but not on it.
bool is_beside(const Point& p, const Stroke& s, double distance) {
  if (distance == 0 || has(s, p)) return false;
  const Interval found = estimated_distance(p, s);
  if (found.high <= distance || found.low > distance) return found.high <= distance;
  return squared_distance(RationalPoint(p), s.a, s.b) <= Rational(distance) * Rational(distance);
}

}  // namespace

bool has_inside(const Stroke& e, const Point& p) {
  return e.a != e.b && p != e.a && p != e.b && e.box().meets(Box(p, p)) && side_of_line(e.a, e.b, p) == 0;
}

bool has(const Stroke& e, const Point& p) { return p == e.a || p == e.b || has_inside(e, p); }

ZoneArrangement::ZoneArrangement(const JudgedZones& zones, double moved) {
  collect(zones);
  std::vector<Box> boxes;
  for (const ZoneEdge& e : edges_) boxes.push_back(e.box());
  tree_ = BoxTree(std::move(boxes));
  find_moved(moved);
}

void ZoneArrangement::collect(const JudgedZones& zones) {
  std::vector<Stroke> borders;
  for (std::size_t r = 0; r < zones.rows.feature_count(); ++r)
    for (const PolygonView polygon : regions_of(zones.rows, r).polygons()) {
      std::vector<Stroke> edges = boundary_of(polygon);
      borders.insert(borders.end(), edges.begin(), edges.end());
      rows_.add(std::move(edges), zones.keys[r].a);
    }
  std::sort(borders.begin(), borders.end(), [](const Stroke& s, const Stroke& t) {
    return s.a != t.a ? lexicographically_less(s.a, t.a) : lexicographically_less(s.b, t.b);
  });
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  for (const Stroke& s : borders) edges_.push_back({s, ZoneEdge::row});
  for (const PolygonView polygon : zones.frame.polygons()) {
    std::vector<Stroke> edges = boundary_of(polygon);
    for (const Stroke& s : edges) edges_.push_back({s, ZoneEdge::frame});
    frame_.add(std::move(edges), 0);
  }
  for (const ZoneObjects::Edge& e : zones.objects.edges)
    edges_.push_back({e, e.of_region ? ZoneEdge::region : ZoneEdge::line, e.object});
  rows_.build();
  frame_.build();
}

// Edges that cross at a place that is no double, and those that come near to another one without touching it there.
// Borders of cells cut the frame, and near places where objects meet also these, at places beside them.
void ZoneArrangement::find_moved(double moved) {
  for (ZoneEdge& s : edges_) {
    if (s.of == ZoneEdge::row) continue;
    bool is_cut_by_rows = false, meets_others = s.of == ZoneEdge::frame;
    for_each_near(s, moved, [&](const ZoneEdge& t) {
      if (s.may_move) return;
      if (t.of == ZoneEdge::row) {
        is_cut_by_rows = is_cut_by_rows || is_beside(t.a, s, moved) || is_beside(t.b, s, moved);
      } else if (cross(s, t)) {
        const auto at = intersection_of_segments(s.a, s.b, t.a, t.b);
        s.may_move = !is_double(at->x) || !is_double(at->y);
        meets_others = true;
      } else {
        s.may_move = is_beside(t.a, s, moved) || is_beside(t.b, s, moved) || is_beside(s.a, t, moved) ||
                     is_beside(s.b, t, moved);
        meets_others = meets_others || (t.object != s.object && touches(s, t));
      }
    });
    s.may_move = s.may_move || (is_cut_by_rows && meets_others);
  }
  while (spread_along_lines()) {
  }
}

// Boundaries are cut at vertices on their edges. Where such a vertex is no corner of the row, the row has one edge, and
// what moves one end of it moves all of it.
bool ZoneArrangement::spread_along_lines() {
  bool any = false;
  for (ZoneEdge& s : edges_) {
    if (s.of == ZoneEdge::row || s.may_move || s.a == s.b) continue;
    for_each_near(s, 0, [&](const ZoneEdge& t) {
      if (t.of != s.of || t.object != s.object || !t.may_move || t.a == t.b || !touches(s, t)) return;
      s.may_move = s.may_move || (side_of_line(s.a, s.b, t.a) == 0 && side_of_line(s.a, s.b, t.b) == 0);
    });
    any = any || s.may_move;
  }
  return any;
}

std::vector<Location> ZoneArrangement::cuts_of(const ZoneEdge& s) const {
  std::vector<Point> points{s.a, s.b};
  std::vector<RationalPoint> crossings;
  for_each_near(s, 0, [&](const ZoneEdge& t) {
    if (s.of == ZoneEdge::row && t.of == ZoneEdge::row) return;
    for (const Point& p : {t.a, t.b})
      if (has_inside(s, p)) points.push_back(p);
    if (cross(s, t)) crossings.push_back(*intersection_of_segments(s.a, s.b, t.a, t.b));
  });
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Location> cuts;
  if (crossings.empty()) {
    for (const Point& p : points) cuts.emplace_back(p);
    return cuts;
  }
  for (const Point& p : points) crossings.emplace_back(p);
  std::sort(crossings.begin(), crossings.end(),
            [](const RationalPoint& p, const RationalPoint& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
  crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
  for (const RationalPoint& p : crossings) cuts.emplace_back(p);
  return cuts;
}

}  // namespace oblast::verify
