// Z1 and Z2. Edges of rows, objects and frame are cut where they meet; the labels of both sides of every piece say
// which objects and rows are there.
//
// Noding moves edges that cross at places that are no doubles. So there may be slivers between such an edge and the row
// edges in its place, where labels are wrong; and slivers of objects and frames that are thinner than that may be gone.
// A fault is excused if it is beside an edge that may have moved, and if a small step away from the piece, or from that
// edge, labels are right again. A line or a point that moved is excused in a row of another object that is as near.
#include <algorithm>
#include <cmath>
#include <string>

#include "verify/edges.h"
#include "verify/predicates.h"
#include "verify/rows.h"
#include "verify/zone_arrangement.h"
#include "verify/zones.h"

namespace oblast::verify {
namespace {

std::string text(const std::vector<std::uint32_t>& numbers) {
  std::string list;
  for (const std::uint32_t n : numbers) list += (list.empty() ? "" : ", ") + std::to_string(n);
  return list.empty() ? "none" : list;
}

class CoverCheck {
 public:
  CoverCheck(const JudgedZones& zones, const ZoneCoverBounds& bounds)
      : zones_(zones), bounds_(bounds), all_(zones, bounds.moved) {}

  std::optional<Fault> run(ZoneCoverMeasures* measures) {
    for (const ZoneEdge& e : all_.edges()) {
      check(e);
      if (fault_) break;
    }
    if (measures) *measures = measures_;
    return fault_;
  }

 private:
  void check(const ZoneEdge& s) {
    if (s.a == s.b) return check_point(s);
    const std::vector<Location> cuts = all_.cuts_of(s);
    for (std::size_t i = 0; i + 1 < cuts.size() && !fault_; ++i) check_piece(s, cuts[i], cuts[i + 1]);
  }

  void check_piece(const ZoneEdge& s, const Location& from, const Location& to) {
    ++measures_.pieces;
    const Location middle(from, to);
    std::string what = fault_at(middle, s.a.y == s.b.y);
    if (!what.empty()) {
      if (is_sliver(s, from, middle, to))
        ++measures_.excused;
      else
        return fail(what, middle.rounded());
    }
    if (s.of == ZoneEdge::line && !is_in_own_row(s, middle)) {
      const std::vector<std::uint32_t> holders = holders_of_line(s, middle);
      if (s.may_move && is_near_row(holders, from) && is_near_row(holders, middle) && is_near_row(holders, to))
        ++measures_.excused;
      else
        fail("a line of object " + std::to_string(s.object) + " is not in its row", middle.rounded());
    }
  }

  /// What is wrong with the labels of both sides of a place; empty: nothing.
  std::string fault_at(const Location& p, bool on_horizontal) const {
    const auto regions = zones_.objects.regions.beside(p, on_horizontal), rows = all_.rows().beside(p, on_horizontal);
    const auto frame = all_.frame().beside(p, on_horizontal);
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

  bool is_in_own_row(const ZoneEdge& s, const Location& p) const {
    const bool on_horizontal = s.a.y == s.b.y;
    const auto frame = all_.frame().beside(p, on_horizontal), rows = all_.rows().beside(p, on_horizontal);
    if (frame.first.empty() && frame.second.empty()) return true;
    const std::vector<std::uint32_t> holders = holders_of_line(s, p);
    return holds_any(rows.first, holders) || holds_any(rows.second, holders);
  }

  /// The objects that may have a place of a line: regions that it is in, or on the outline of, and the lowest line
  /// there.
  std::vector<std::uint32_t> holders_of_line(const ZoneEdge& s, const Location& p) const {
    const bool on_horizontal = s.a.y == s.b.y;
    std::vector<std::uint32_t> holders;
    const auto regions = zones_.objects.regions.beside(p, on_horizontal);
    holders.insert(holders.end(), regions.first.begin(), regions.first.end());
    holders.insert(holders.end(), regions.second.begin(), regions.second.end());
    std::uint32_t lowest = s.object;
    all_.for_each_near(s, 0, [&](const ZoneEdge& t) {
      if (t.of == ZoneEdge::line && t.a != t.b && side_of_line(t.a, t.b, s.a) == 0 &&
          side_of_line(t.a, t.b, s.b) == 0 && t.box().meets(p.box()))
        lowest = std::min(lowest, t.object);
    });
    holders.push_back(lowest);
    return holders;
  }

  static bool holds_any(const std::vector<std::uint32_t>& ascending, const std::vector<std::uint32_t>& wanted) {
    return std::any_of(wanted.begin(), wanted.end(), [&](std::uint32_t object) {
      return std::binary_search(ascending.begin(), ascending.end(), object);
    });
  }

  void check_point(const ZoneEdge& s) {
    ++measures_.pieces;
    if (all_.frame().closed_at(s.a).empty()) return;
    const std::vector<std::uint32_t> rows = all_.rows().closed_at(s.a);
    if (holds_any(rows, holders_of(s))) return;
    if (s.may_move && is_near_row(holders_of(s), Location(s.a)))
      ++measures_.excused;
    else
      fail("a point of object " + std::to_string(s.object) + " is in row " + text(rows), s.a);
  }

  /// The objects that may have a point: regions and lines that hold it, else the lowest of equal points.
  std::vector<std::uint32_t> holders_of(const ZoneEdge& point) const {
    std::vector<std::uint32_t> holders = zones_.objects.regions.closed_at(point.a);
    std::uint32_t lowest = point.object;
    all_.for_each_near(point, 0, [&](const ZoneEdge& t) {
      if (t.object == no_feature) return;
      if (t.a == t.b) {
        lowest = std::min(lowest, t.object);
      } else if (t.a == point.a || t.b == point.a || has_inside(t, point.a)) {
        holders.push_back(t.object);
      }
    });
    if (holders.empty()) holders.push_back(lowest);
    return holders;
  }

  /// Whether the place is in the row of a holder or of an object that is as near as edges may have moved, or so near to
  /// one; or as near to where the frame may have moved.
  bool is_near_row(std::vector<std::uint32_t> holders, const Location& p) const {
    const ZoneEdge here{{p.rounded(), p.rounded()}, ZoneEdge::line};
    bool found = false;
    all_.for_each_near(here, bounds_.moved, [&](const ZoneEdge& t) {
      if (t.of == ZoneEdge::row || !is_near(p, t)) return;
      if (t.of == ZoneEdge::frame) found |= t.may_move;
      if (t.object != no_feature) holders.push_back(t.object);
    });
    found = found || holds_any(all_.rows().closed_at(p.rounded()), holders);
    all_.for_each_near(here, bounds_.moved, [&](const ZoneEdge& t) {
      if (found || t.of != ZoneEdge::row || !is_near(p, t)) return;
      const auto sides = all_.rows().beside(Location(Location(t.a), Location(t.b)), t.a.y == t.b.y);
      found = holds_any(sides.first, holders) || holds_any(sides.second, holders);
    });
    return found;
  }

  bool is_near(const Location& p, const Stroke& s) const {
    return squared_distance(p.exact(), s.a, s.b) <= Rational(bounds_.moved) * Rational(bounds_.moved);
  }

  /// Whether the piece is beside a sliver: an edge that may have moved on one hand, its pieces in the rows on the
  /// other.
  bool is_sliver(const ZoneEdge& s, const Location& from, const Location& middle, const Location& to) const {
    if (bounds_.moved == 0 || (s.of != ZoneEdge::row && !s.may_move)) return false;
    std::vector<Stroke> beside{s};
    for (const Location* p : {&from, &middle, &to}) {
      bool found = false;
      all_.for_each_near({{p->rounded(), p->rounded()}, ZoneEdge::line}, 2 * bounds_.moved, [&](const ZoneEdge& t) {
        if (found || &t == &s || t.a == t.b) return;
        // In place of the edge there are edges of rows, or nothing where another edge of the same area is beside it.
        const bool matters = s.of == ZoneEdge::row ? t.of != ZoneEdge::row && t.may_move
                                                   : t.of == ZoneEdge::row || (t.of == s.of && t.object == s.object);
        if (!matters || (p == &middle && s.of != ZoneEdge::row && side_of_line(t.a, t.b, *p) == 0)) return;
        found = is_near(*p, t);
        if (found && p == &middle) beside.push_back(t);
      });
      if (!found) return false;
    }
    return std::any_of(beside.begin(), beside.end(), [&](const Stroke& t) { return is_right_away_from(t, middle); });
  }

  bool is_right_away_from(const Stroke& s, const Location& middle) const {
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
  ZoneArrangement all_;
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
