// Z1 and Z2. Edges of rows, objects and frame are cut where they meet; the labels of both sides of every piece say
// which objects and rows are there.
//
// Noding moves edges that cross at places that are no doubles. So there may be slivers between such an edge and another
// one, where labels are wrong or which are gone.
// A fault is excused if it is beside an edge that may have moved, and if a small step away from the piece labels are
// right again. A line or a point that moved is excused in the row of another object that is as near.
#include <algorithm>
#include <cmath>
#include <string>

#include "verify/distance.h"
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
    if (s.of != ZoneEdge::line) return;
    const std::vector<std::uint32_t> holders = holders_of(s, middle);
    if (is_in_own_row(s, middle, holders)) return;
    const auto everywhere = [&](const auto& is_excused) {
      return is_excused(from) && is_excused(middle) && is_excused(to);
    };
    if (everywhere([&](const Location& p) {
          std::vector<std::uint32_t> near = holders;
          return is_in_near_row(near, p);
        }) ||
        (s.may_move && everywhere([&](const Location& p) { return is_near_row(holders, p); })))
      ++measures_.excused;
    else
      fail("a line of object " + std::to_string(s.object) + " is not in its row", middle.rounded());
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
    if (rows.empty() && bounds_.is_whole && !zones_.objects.edges.empty()) return "a place of the frame is in no row";
    if (!regions.empty() && (rows.empty() || rows[0] != regions[0]))
      return "a place in regions of objects (" + text(regions) + ") is in row " + text(rows);
    return {};
  }

  bool is_in_own_row(const ZoneEdge& s, const Location& p, const std::vector<std::uint32_t>& holders) const {
    const bool on_horizontal = s.a.y == s.b.y;
    const auto frame = all_.frame().beside(p, on_horizontal), rows = all_.rows().beside(p, on_horizontal);
    if (frame.first.empty() && frame.second.empty()) return true;
    return holds_any(rows.first, holders) || holds_any(rows.second, holders);
  }

  /// The objects that may have a place of a line: the lowest of the lines that hold it, and regions that do.
  std::vector<std::uint32_t> holders_of(const ZoneEdge& s, const Location& p) const {
    auto [holders, others] = zones_.objects.regions.beside(p, s.a.y == s.b.y);
    holders.insert(holders.end(), others.begin(), others.end());
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
    const std::vector<std::uint32_t> holders = holders_of(s);
    if (holds_any(rows, holders)) return;
    if ((s.may_move || touches_moved(s)) && is_near_row(holders, Location(s.a)))
      ++measures_.excused;
    else
      fail("a point of object " + std::to_string(s.object) + " is in row " + text(rows), s.a);
  }

  /// Whether the point is on an edge that may have moved. Where such edges make a thin spike, its end may be gone.
  bool touches_moved(const ZoneEdge& point) const {
    bool found = false;
    all_.for_each_near(point, 0,
                       [&](const ZoneEdge& t) { found |= t.of != ZoneEdge::row && t.may_move && has(t, point.a); });
    return found;
  }

  /// The objects that may have a point: regions and lines that hold it, else the lowest of equal points.
  std::vector<std::uint32_t> holders_of(const ZoneEdge& point) const {
    std::vector<std::uint32_t> holders = zones_.objects.regions.closed_at(point.a);
    std::uint32_t lowest = point.object;
    all_.for_each_near(point, 0, [&](const ZoneEdge& t) {
      if (t.object == no_feature) return;
      if (t.a == t.b) {
        lowest = std::min(lowest, t.object);
      } else if (has(t, point.a)) {
        holders.push_back(t.object);
      }
    });
    if (holders.empty()) holders.push_back(lowest);
    return holders;
  }

  /// Whether the place is in the row of a holder, or of an object that is as near as edges may have moved; or so near
  /// to where the frame may have moved. Adds these objects to the holders.
  bool is_in_near_row(std::vector<std::uint32_t>& holders, const Location& p) const {
    bool found = false;
    all_.for_each_near(at(p), bounds_.moved, [&](const ZoneEdge& t) {
      if (t.of == ZoneEdge::row || !is_near(p, t)) return;
      if (t.of == ZoneEdge::frame) found |= t.may_move;
      if (t.object != no_feature) holders.push_back(t.object);
    });
    return found || holds_any(all_.rows().closed_at(p.rounded()), holders);
  }

  /// The same, or the place is near to such a row.
  bool is_near_row(std::vector<std::uint32_t> holders, const Location& p) const {
    bool found = is_in_near_row(holders, p);
    all_.for_each_near(at(p), bounds_.moved, [&](const ZoneEdge& t) {
      if (found || t.of != ZoneEdge::row || !is_near(p, t)) return;
      const auto sides = all_.rows().beside(Location(Location(t.a), Location(t.b)), t.a.y == t.b.y);
      found = holds_any(sides.first, holders) || holds_any(sides.second, holders);
    });
    return found;
  }

  static ZoneEdge at(const Location& p) { return {{p.rounded(), p.rounded()}, ZoneEdge::line}; }

  bool is_near(const Location& p, const Stroke& s) const {
    const Box box = p.box();
    const double off = (box.high.x - box.low.x) + (box.high.y - box.low.y);
    const Interval found = estimated_distance(p.rounded(), s);
    if ((found.high + off) * (1 + 0x1p-50) <= bounds_.moved) return true;
    if ((found.low - off) * (1 - 0x1p-50) > bounds_.moved) return false;
    return squared_distance(p.exact(), s.a, s.b) <= Rational(bounds_.moved) * Rational(bounds_.moved);
  }

  /// Whether the piece is beside a sliver, or crosses one: a sliver lies between two edges, not both along the piece,
  /// and one of them may have moved.
  bool is_sliver(const ZoneEdge& s, const Location& from, const Location& middle, const Location& to) const {
    if (bounds_.moved == 0) return false;
    for (const Location* p : {&from, &middle, &to}) {
      bool moved = s.may_move, beside = false;
      all_.for_each_near(at(*p), 2 * bounds_.moved, [&](const ZoneEdge& t) {
        if (&t == &s || t.a == t.b || !is_near(*p, t)) return;
        moved = moved || t.may_move;
        beside = beside || p != &middle || side_of_line(t.a, t.b, *p) != 0;
      });
      if (!moved || !beside) return false;
    }
    return is_right_away_from(s, middle);
  }

  /// Whether labels are right at some place on each side of the edge that is a little further away than slivers are
  /// wide. An edge may cross a sliver, so a step may go along it.
  bool is_right_away_from(const ZoneEdge& s, const Location& middle) const {
    bool right[2] = {};
    for (const double steps : {1.5, 3.0, 6.0, 12.0})
      for (const auto& [dx, dy] : {std::pair(1, 0), {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}) {
        const double left_of_edge = (s.b.x - s.a.x) * dy - (s.b.y - s.a.y) * dx;
        bool& is_right = right[left_of_edge > 0];
        if (left_of_edge == 0 || is_right) continue;
        const Rational step(steps * bounds_.moved);
        const RationalPoint& at = middle.exact();
        is_right = fault_at(Location(RationalPoint(at.x + step * dx, at.y + step * dy)), false).empty();
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
