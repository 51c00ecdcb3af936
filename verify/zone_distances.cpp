// Z3. Distances are estimated in doubles with a bound of the error; if that does not decide, squared distances are
// compared as rational numbers.
#include <algorithm>
#include <cmath>
#include <string>

#include "verify/distance.h"
#include "verify/edges.h"
#include "verify/predicates.h"
#include "verify/rows.h"
#include "verify/zone_places.h"
#include "verify/zones.h"

namespace oblast::verify {
namespace {

Rational squared(const Rational& value) { return value * value; }

class DistanceCheck {
 public:
  DistanceCheck(const JudgedZones& zones, const ZoneDistanceBounds& bounds) : zones_(zones), bounds_(bounds) {
    for (std::size_t r = 0; r < zones.rows.feature_count(); ++r)
      for (const PolygonView polygon : regions_of(zones.rows, r).polygons()) {
        std::vector<Stroke> edges;
        for (const std::span<const Point> ring : polygon.contours())
          for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
        rows_.add(std::move(edges), zones.keys[r].a);
      }
    rows_.build();
    for (const PolygonView polygon : zones.frame.polygons()) frame_.add(boundary_of(polygon), 0);
    frame_.build();
  }

  std::optional<Fault> run(ZoneDistanceMeasures* measures) {
    for (const Point& p : zone_places(zones_, bounds_.places, bounds_.seed)) {
      check(p);
      if (fault_) break;
    }
    if (measures) *measures = measures_;
    return fault_;
  }

 private:
  struct Near {
    const ZoneObjects::Edge* edge;
    Interval distance;
  };

  /// The edges that may be the nearest one, or not further than `margin` behind it.
  void find_near(const Point& p, double margin) {
    near_.clear();
    double most = HUGE_VAL;
    const auto limit = [&] { return (most + margin) * (1 + 0x1p-40); };
    const auto& objects = zones_.objects;
    objects.tree.near(p, limit, [&](std::uint32_t k) {
      const Interval found = estimated_distance(p, objects.edges[k]);
      most = std::min(most, found.high);
      if (found.low <= limit()) near_.push_back({&objects.edges[k], found});
    });
    std::erase_if(near_, [&](const Near& n) { return n.distance.low > limit(); });
  }

  void check(const Point& p) {
    if (fault_) return;
    const std::vector<std::uint32_t> rows = rows_.closed_at(p);
    const std::vector<std::uint32_t> holders = zones_.objects.regions.closed_at(p);
    if (rows.empty()) return check_far(p, holders);
    find_near(p, bounds_.epsilon);
    for (const std::uint32_t object : rows) check(p, object, holders);
  }

  void check(const Point& p, std::uint32_t own, const std::vector<std::uint32_t>& holders) {
    ++measures_.places;
    if (std::binary_search(holders.begin(), holders.end(), own)) return;
    Interval others{HUGE_VAL, HUGE_VAL};
    own_.clear();
    for (const Near& n : near_) {
      if (n.edge->object == own)
        own_.push_back(n);
      else
        others = least(others, n.distance);
    }
    if (!holders.empty()) others = {0, 0};
    // Edges of the object that are not near are looked for if it has none, or if its distance is not one to compare.
    if (own_.empty() || !holders.empty()) find_own(p, own);
    Interval mine{HUGE_VAL, HUGE_VAL};
    for (const Near& n : own_) mine = least(mine, n.distance);
    if (own_.empty()) return fail("row " + std::to_string(own) + " has no object", p);
    const std::uint64_t excused = measures_.excused;
    if (!is_surely_within(mine, others) && !is_exactly_within(p, mine, holders))
      fail("object " + std::to_string(own) + " is further than another one by " +
               std::to_string((mine.high - others.low) / bounds_.epsilon) + " epsilon",
           p);
    if (others.high < HUGE_VAL && measures_.excused == excused) {
      const double excess = (mine.low + mine.high) / 2 - (others.low + others.high) / 2;
      measures_.epsilon = std::max(measures_.epsilon, excess);
    }
    if (is_too_far(p, mine)) fail("a place of row " + std::to_string(own) + " is further than the largest distance", p);
  }

  /// The largest distance is kept from all of an object, also from parts that are too thin to have a zone.
  bool is_too_far(const Point& p, const Interval& mine) {
    if (mine.high * (1 + 0x1p-50) <= bounds_.upper || squared_distance_of(p, mine) <= squared(Rational(bounds_.upper)))
      return false;
    const bool is_excused =
        std::any_of(near_.begin(), near_.end(), [&](const Near& n) { return is_thin_at(p, *n.edge, 0); });
    measures_.excused += is_excused;
    return !is_excused;
  }

  static Interval least(const Interval& a, const Interval& b) {
    return {std::min(a.low, b.low), std::min(a.high, b.high)};
  }

  bool is_surely_within(const Interval& mine, const Interval& other) const {
    return mine.high * (1 + 0x1p-50) <= (other.low + bounds_.epsilon) * (1 - 0x1p-50);
  }

  void find_own(const Point& p, std::uint32_t object) {
    own_.clear();
    for (const ZoneObjects::Edge& e : zones_.objects.edges)
      if (e.object == object) own_.push_back({&e, estimated_distance(p, e)});
  }

  Rational squared_distance_of(const Point& p, const Interval& mine) const {
    std::optional<Rational> nearest;
    for (const Near& n : own_) {
      if (n.distance.low > mine.high) continue;
      const Rational found = squared_distance(RationalPoint(p), n.edge->a, n.edge->b);
      if (!nearest || found < *nearest) nearest = found;
    }
    return *nearest;
  }

  bool is_exactly_within(const Point& p, const Interval& mine, std::span<const std::uint32_t> holders) {
    ++measures_.exactly;
    const Rational square = squared_distance_of(p, mine), epsilon(bounds_.epsilon);
    if (!holders.empty()) return root_is_within(square, 0, epsilon) || is_in_thin_parts(p, holders);
    return std::all_of(near_.begin(), near_.end(), [&](const Near& n) {
      if (is_surely_within(mine, n.distance) ||
          root_is_within(square, squared_distance(RationalPoint(p), n.edge->a, n.edge->b), epsilon))
        return true;
      const bool is_excused = is_thin_at(p, *n.edge, mine.high - bounds_.epsilon);
      measures_.excused += is_excused;
      return is_excused;
    });
  }

  /// Whether the polygon at the edge is thinner than edges may have moved, wherever the edge is nearer to p than
  /// `reach`, and at least some way along it: near every corner a polygon is thin.
  bool is_thin_at(const Point& p, const ZoneObjects::Edge& e, double reach) const {
    if (!e.of_region || bounds_.moved == 0) return false;
    const double ex = e.b.x - e.a.x, ey = e.b.y - e.a.y, length = std::sqrt(ex * ex + ey * ey);
    const double foot = ((p.x - e.a.x) * ex + (p.y - e.a.y) * ey) / (length * length),
                 nearest = std::clamp(foot, 0.0, 1.0);
    const double aside = std::abs((p.x - e.a.x) * ey - (p.y - e.a.y) * ex) / length;
    const double nearer = reach > aside ? std::sqrt((reach - aside) * (reach + aside)) / length : 0;
    const double some_way = 8 * bounds_.moved / length;
    const double begin = std::clamp(std::min(foot - nearer, nearest - some_way), 0.0, 1.0);
    const double end = std::clamp(std::max(foot + nearer, nearest + some_way), 0.0, 1.0);
    for (int k = 0; k <= 8; ++k) {
      const double t = begin + (end - begin) * k / 8;
      if (!is_near_another({e.a.x + ex * t, e.a.y + ey * t}, e)) return false;
    }
    return true;
  }

  bool is_near_another(const Point& on_edge, const ZoneObjects::Edge& e) const {
    bool found = false;
    const auto limit = [&] { return 2 * bounds_.moved; };
    zones_.objects.tree.near(on_edge, limit, [&](std::uint32_t k) {
      const ZoneObjects::Edge& other = zones_.objects.edges[k];
      if (&other != &e && other.of_region && other.object == e.object)
        found |= estimated_distance(on_edge, other).low <= 2 * bounds_.moved;
    });
    return found;
  }

  bool is_in_thin_parts(const Point& p, std::span<const std::uint32_t> holders) {
    const bool is_excused = std::all_of(holders.begin(), holders.end(), [&](std::uint32_t object) {
      bool is_thin = false;
      zones_.objects.tree.near(
          p, [&] { return bounds_.moved; },
          [&](std::uint32_t k) {
            const ZoneObjects::Edge& e = zones_.objects.edges[k];
            is_thin |= e.object == object && estimated_distance(p, e).low <= bounds_.moved && is_thin_at(p, e, 0);
          });
      return is_thin;
    });
    measures_.excused += is_excused;
    return is_excused;
  }

  /// With a largest distance: a place of the frame in no row.
  void check_far(const Point& p, const std::vector<std::uint32_t>& holders) {
    if (bounds_.lower == HUGE_VAL || !is_in_frame(p)) return;
    find_near(p, 0);
    const bool is_near = std::any_of(near_.begin(), near_.end(), [&](const Near& n) {
      return n.distance.low < bounds_.lower &&
             squared_distance(RationalPoint(p), n.edge->a, n.edge->b) < squared(Rational(bounds_.lower)) &&
             !is_thin_at(p, *n.edge, bounds_.lower);
    });
    if (is_near || (!holders.empty() && !is_in_thin_parts(p, holders)))
      fail("a place nearer than the largest distance is in no row", p);
  }

  bool is_in_frame(const Point& p) const {
    return std::any_of(frame_.areas.begin(), frame_.areas.end(), [&](const Area& area) {
      return area.where(p) == Area::Where::inside &&
             std::none_of(area.edges().begin(), area.edges().end(),
                          [&](const Stroke& e) { return estimated_distance(p, e).low <= bounds_.moved; });
    });
  }

  void fail(const std::string& what, const Point& p) {
    if (!fault_) fault_ = Fault{what + ", at " + to_text(p), {}};
  }

  const JudgedZones& zones_;
  const ZoneDistanceBounds& bounds_;
  NumberedAreas rows_, frame_;
  std::vector<Near> near_, own_;
  ZoneDistanceMeasures measures_;
  std::optional<Fault> fault_;
};

}  // namespace

std::optional<Fault> check_zone_distances(const JudgedZones& zones, const ZoneDistanceBounds& bounds,
                                          ZoneDistanceMeasures* measures) {
  return DistanceCheck(zones, bounds).run(measures);
}

}  // namespace oblast::verify
