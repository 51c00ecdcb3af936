// Z1 and Z2. Edges of rows, objects and frame are cut where they meet; the labels of both sides of every piece say which
// objects and rows are there.
//
// Noding moves edges that cross at places that are no doubles. So there may be slivers between such an edge and the row
// edges in its place, where labels are wrong. A fault is excused if it is beside an edge that may have moved, and if a
// small step away from the piece labels are right again.
#include <algorithm>
#include <cmath>
#include <string>

#include "verify/edges.h"
#include "verify/predicates.h"
#include "verify/rows.h"
#include "verify/zones.h"

namespace oblast::verify {
namespace {

enum class Kind { row, region, line, frame };

struct Source : Stroke {
  Kind kind;
  std::uint32_t object = no_feature;
  bool may_move = false;
};


double distance(const Point& p, const Stroke& s) {
  return std::sqrt(static_cast<double>(squared_distance(RationalPoint(p), s.a, s.b)));
}

bool is_double(const Rational& value) { return Rational(round_to_nearest(value)) == value; }

std::string text(const std::vector<std::uint32_t>& numbers) {
  std::string list;
  for (const std::uint32_t n : numbers) list += (list.empty() ? "" : ", ") + std::to_string(n);
  return list.empty() ? "none" : list;
}

class CoverCheck {
 public:
  CoverCheck(const JudgedZones& zones, const ZoneCoverBounds& bounds) : zones_(zones), bounds_(bounds) {
    collect();
    std::vector<Box> boxes;
    for (const Source& s : sources_) boxes.push_back(s.box());
    tree_ = BoxTree(std::move(boxes));
  }

  std::optional<Fault> run(ZoneCoverMeasures* measures) {
    find_moved();
    for (std::uint32_t s = 0; s < sources_.size() && !fault_; ++s) check(s);
    if (measures) *measures = measures_;
    return fault_;
  }

 private:
  void collect() {
    std::vector<Stroke> borders;
    for (std::size_t r = 0; r < zones_.rows.feature_count(); ++r)
      for (const PolygonView polygon : regions_of(zones_.rows, r).polygons()) {
        std::vector<Stroke> edges = boundary_of(polygon);
        borders.insert(borders.end(), edges.begin(), edges.end());
        rows_.add(std::move(edges), zones_.keys[r].a);
      }
    std::sort(borders.begin(), borders.end(), [](const Stroke& s, const Stroke& t) {
      return s.a != t.a ? lexicographically_less(s.a, t.a) : lexicographically_less(s.b, t.b);
    });
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
    for (const Stroke& s : borders) sources_.push_back({s, Kind::row});
    for (const PolygonView polygon : zones_.frame.polygons()) {
      std::vector<Stroke> edges = boundary_of(polygon);
      for (const Stroke& s : edges) sources_.push_back({s, Kind::frame});
      frame_.add(std::move(edges), 0);
    }
    for (const ZoneObjects::Edge& e : zones_.objects.edges)
      sources_.push_back({e, e.of_region ? Kind::region : Kind::line, e.object});
    rows_.build();
    frame_.build();
  }

  static bool holds(const Source& s, const Point& p) {
    return p != s.a && p != s.b && s.box().meets(Box(p, p)) && side_of_line(s.a, s.b, p) == 0;
  }

  static bool cross(const Source& s, const Source& t) {
    if (s.a == s.b || t.a == t.b) return false;
    return side_of_line(s.a, s.b, t.a) * side_of_line(s.a, s.b, t.b) < 0 &&
           side_of_line(t.a, t.b, s.a) * side_of_line(t.a, t.b, s.b) < 0;
  }

  template <class Visit>
  void for_each_near(const Source& s, double margin, const Visit& visit) const {
    Box box = s.box();
    box.low = {box.low.x - margin, box.low.y - margin};
    box.high = {box.high.x + margin, box.high.y + margin};
    tree_.meeting(box, [&](std::uint32_t k) {
      if (&sources_[k] != &s) visit(sources_[k]);
    });
  }

  // Edges that cross at a place that is no double, and those that come near to another one without touching it there.
  void find_moved() {
    for (Source& s : sources_) {
      if (s.kind == Kind::row) continue;
      for_each_near(s, bounds_.moved, [&](const Source& t) {
        if (s.may_move) return;
        if (t.kind == Kind::row) {
          // The frame is cut by borders, at places beside it.
          if (s.kind == Kind::frame) s.may_move = is_beside(t.a, s) || is_beside(t.b, s);
        } else if (cross(s, t)) {
          const auto at = intersection_of_segments(s.a, s.b, t.a, t.b);
          s.may_move = !is_double(at->x) || !is_double(at->y);
        } else {
          s.may_move = is_beside(t.a, s) || is_beside(t.b, s) || is_beside(s.a, t) || is_beside(s.b, t);
        }
      });
    }
  }

  bool is_beside(const Point& p, const Stroke& s) const {
    if (p == s.a || p == s.b || bounds_.moved == 0) return false;
    if (s.a != s.b && side_of_line(s.a, s.b, p) == 0 && s.box().meets(Box(p, p))) return false;
    return distance(p, s) <= bounds_.moved;
  }

  /// Where others meet the source, with its ends, along it.
  std::vector<Location> cuts_of(const Source& s) const {
    std::vector<Point> points{s.a, s.b};
    std::vector<RationalPoint> crossings;
    for_each_near(s, 0, [&](const Source& t) {
      if (s.kind == Kind::row && t.kind == Kind::row) return;
      for (const Point& p : {t.a, t.b})
        if (holds(s, p)) points.push_back(p);
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
    std::sort(crossings.begin(), crossings.end(), [](const RationalPoint& p, const RationalPoint& q) {
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
    for (const RationalPoint& p : crossings) cuts.emplace_back(p);
    return cuts;
  }

  void check(std::uint32_t number) {
    const Source& s = sources_[number];
    if (s.a == s.b) return check_point(s);
    const std::vector<Location> cuts = cuts_of(s);
    for (std::size_t i = 0; i + 1 < cuts.size() && !fault_; ++i) check_piece(s, cuts[i], cuts[i + 1]);
  }

  void check_piece(const Source& s, const Location& from, const Location& to) {
    ++measures_.pieces;
    const Location middle(from, to);
    std::string what = fault_at(middle, s.a.y == s.b.y);
    if (!what.empty()) {
      if (is_sliver(s, from, middle, to))
        ++measures_.excused;
      else
        return fail(what, middle.rounded());
    }
    if (s.kind == Kind::line && !is_in_own_row(s, middle)) {
      if (s.may_move && is_near_row(s.object, from) && is_near_row(s.object, to))
        ++measures_.excused;
      else
        fail("a line of object " + std::to_string(s.object) + " is not in its row", middle.rounded());
    }
  }

  /// What is wrong with the labels of both sides of a place; empty: nothing.
  std::string fault_at(const Location& p, bool on_horizontal) const {
    const auto regions = zones_.objects.regions.beside(p, on_horizontal), rows = rows_.beside(p, on_horizontal);
    const auto frame = frame_.beside(p, on_horizontal);
    std::string what = fault_of(frame.first, regions.first, rows.first);
    return what.empty() ? fault_of(frame.second, regions.second, rows.second) : what;
  }

  std::string fault_of(const std::vector<std::uint32_t>& frame, const std::vector<std::uint32_t>& regions,
                       const std::vector<std::uint32_t>& rows) const {
    if (frame.empty()) return rows.empty() ? "" : "rows reach out of the frame: " + text(rows);
    if (rows.size() > 1) return "rows overlap: " + text(rows);
    if (rows.empty() && bounds_.is_whole) return "a place of the frame is in no row";
    if (!regions.empty() && (rows.empty() || rows[0] != regions[0]))
      return "a place in regions of objects (" + text(regions) + ") is in row " + text(rows);
    return {};
  }

  bool is_in_own_row(const Source& s, const Location& p) const {
    const bool on_horizontal = s.a.y == s.b.y;
    const auto frame = frame_.beside(p, on_horizontal), rows = rows_.beside(p, on_horizontal);
    if (frame.first.empty() && frame.second.empty()) return true;
    std::vector<std::uint32_t> holders;
    const auto regions = zones_.objects.regions.beside(p, on_horizontal);
    holders.insert(holders.end(), regions.first.begin(), regions.first.end());
    holders.insert(holders.end(), regions.second.begin(), regions.second.end());
    if (holders.empty()) {  // the lowest of the lines
      holders.push_back(s.object);
      for_each_near(s, 0, [&](const Source& t) {
        if (t.kind == Kind::line && t.a != t.b && side_of_line(t.a, t.b, s.a) == 0 &&
            side_of_line(t.a, t.b, s.b) == 0 && t.box().meets(p.box()))
          holders[0] = std::min(holders[0], t.object);
      });
    }
    return holds_any(rows.first, holders) || holds_any(rows.second, holders);
  }

  static bool holds_any(const std::vector<std::uint32_t>& ascending, const std::vector<std::uint32_t>& wanted) {
    return std::any_of(wanted.begin(), wanted.end(), [&](std::uint32_t object) {
      return std::binary_search(ascending.begin(), ascending.end(), object);
    });
  }

  void check_point(const Source& s) {
    ++measures_.pieces;
    if (frame_.closed_at(s.a).empty()) return;
    const std::vector<std::uint32_t> rows = rows_.closed_at(s.a);
    if (holds_any(rows, holders_of(s))) return;
    if (s.may_move && is_near_row(s.object, Location(s.a)))
      ++measures_.excused;
    else
      fail("a point of object " + std::to_string(s.object) + " is in row " + text(rows), s.a);
  }

  /// The objects that may have a point: regions and lines that hold it, else the lowest of equal points.
  std::vector<std::uint32_t> holders_of(const Source& point) const {
    std::vector<std::uint32_t> holders = zones_.objects.regions.closed_at(point.a);
    std::uint32_t lowest = point.object;
    for_each_near(point, 0, [&](const Source& t) {
      if (t.object == no_feature) return;
      if (t.a == t.b) {
        lowest = std::min(lowest, t.object);
      } else if (t.a == point.a || t.b == point.a || holds(t, point.a)) {
        holders.push_back(t.object);
      }
    });
    if (holders.empty()) holders.push_back(lowest);
    return holders;
  }

  bool is_near_row(std::uint32_t object, const Location& p) const {
    bool found = false;
    for_each_near({{p.rounded(), p.rounded()}, Kind::line}, bounds_.moved, [&](const Source& t) {
      if (found || t.kind != Kind::row || !is_near(p, t)) return;
      const auto sides = rows_.beside(Location(Location(t.a), Location(t.b)), t.a.y == t.b.y);
      found = std::binary_search(sides.first.begin(), sides.first.end(), object) ||
              std::binary_search(sides.second.begin(), sides.second.end(), object);
    });
    return found;
  }

  bool is_near(const Location& p, const Stroke& s) const {
    return squared_distance(p.exact(), s.a, s.b) <= Rational(bounds_.moved) * Rational(bounds_.moved);
  }

  /// Whether the piece is beside a sliver: an edge that may have moved on one hand, its pieces in the rows on the other.
  bool is_sliver(const Source& s, const Location& from, const Location& middle, const Location& to) const {
    if (bounds_.moved == 0 || (s.kind != Kind::row && !s.may_move)) return false;
    for (const Location* p : {&from, &middle, &to}) {
      bool found = false;
      for_each_near({{p->rounded(), p->rounded()}, Kind::line}, 2 * bounds_.moved, [&](const Source& t) {
        if (found || &t == &s || (s.kind == Kind::row ? t.kind == Kind::row || !t.may_move : t.kind != Kind::row))
          return;
        if (p == &middle && side_of_line(t.a, t.b, *p) == 0) return;
        found = is_near(*p, t);
      });
      if (!found) return false;
    }
    return is_right_away_from(s, middle);
  }

  bool is_right_away_from(const Source& s, const Location& middle) const {
    const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y, length = std::sqrt(dx * dx + dy * dy);
    bool right[2] = {};
    for (const double steps : {1.5, 3.0, 6.0, 12.0})
      for (const int side : {0, 1}) {
        const double step = (side == 0 ? 1 : -1) * steps * bounds_.moved / length;
        const RationalPoint& at = middle.exact();
        const Location away(RationalPoint(at.x - Rational(step * dy), at.y + Rational(step * dx)));
        right[side] = right[side] || fault_at(away, false).empty();
      }
    return right[0] && right[1];
  }

  void fail(const std::string& what, const Point& p) {
    if (!fault_) fault_ = Fault{what + ", at " + to_text(p), {}};
  }

  const JudgedZones& zones_;
  const ZoneCoverBounds& bounds_;
  std::vector<Source> sources_;
  NumberedAreas rows_, frame_;
  BoxTree tree_;
  ZoneCoverMeasures measures_;
  std::optional<Fault> fault_;
};

std::optional<Fault> check_keys(const JudgedZones& zones) {
  if (zones.keys.size() != zones.rows.feature_count()) return Fault{"there is not a key for each row", {}};
  for (std::size_t r = 0; r < zones.keys.size(); ++r) {
    if (r > 0 && !(zones.keys[r - 1] < zones.keys[r])) return Fault{"keys do not ascend", {}};
    if (zones.keys[r].b != no_feature) return Fault{"a key has a second row", {}};
  }
  return {};
}

}  // namespace

std::optional<Fault> check_zone_cover(const JudgedZones& zones, const ZoneCoverBounds& bounds,
                                      ZoneCoverMeasures* measures) {
  if (auto fault = check_keys(zones)) return fault;
  if (auto fault = check_rows(zones.rows)) return fault;
  return CoverCheck(zones, bounds).run(measures);
}

double zone_unit(const JudgedZones& zones) {
  double largest = 0;
  const auto add = [&](const Point& p) { largest = std::max({largest, std::abs(p.x), std::abs(p.y)}); };
  for (const ZoneObjects::Edge& e : zones.objects.edges) add(e.a), add(e.b);
  for (const Point& p : zones.frame.points) add(p);
  for (const Point& p : zones.rows.regions.points) add(p);
  return std::nextafter(largest, HUGE_VAL) - largest;
}

}  // namespace oblast::verify
