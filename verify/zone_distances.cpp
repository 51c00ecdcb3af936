// Z3. Distances are estimated in doubles with a bound of the error; if that does not decide, squared distances are
// compared as rational numbers.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "verify/distance.h"
#include "verify/edges.h"
#include "verify/predicates.h"
#include "verify/rows.h"
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
        borders_.insert(borders_.end(), edges.begin(), edges.end());
        rows_.add(std::move(edges), zones.keys[r].a);
      }
    rows_.build();
    for (const PolygonView polygon : zones.frame.polygons()) frame_.add(boundary_of(polygon), 0);
    frame_.build();
    for (const Area& area : frame_.areas) frame_box_.add(area.box());
  }

  std::optional<Fault> run(ZoneDistanceMeasures* measures) {
    std::mt19937_64 random(bounds_.seed);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (std::uint64_t k = 0; k < bounds_.places && !fault_ && !frame_box_.empty(); ++k) {
      const Point &low = frame_box_.low, &high = frame_box_.high;
      check({low.x + (high.x - low.x) * unit(), low.y + (high.y - low.y) * unit()});
    }
    // All edges in turn if there are few, else some of them.
    const bool is_few = borders_.size() * places_by_edge <= bounds_.places;
    const std::uint64_t edges = is_few ? borders_.size() : bounds_.places / places_by_edge + 1;
    for (std::uint64_t k = 0; k < edges && !fault_ && !borders_.empty(); ++k) {
      const Stroke& e = borders_[is_few ? k : random() % borders_.size()];
      const double t = unit();
      const Point places[] = {e.a, at(e, 0.5), at(e, t)};
      for (const Point& p : places) {
        check(p);
        check({step(p.x, random()), step(p.y, random())});
      }
    }
    if (measures) *measures = measures_;
    return fault_;
  }

 private:
  static constexpr std::uint64_t places_by_edge = 6;

  static Point at(const Stroke& e, double t) { return {e.a.x + (e.b.x - e.a.x) * t, e.a.y + (e.b.y - e.a.y) * t}; }

  /// Up to 4 units in the last place away.
  static double step(double x, std::uint64_t random) {
    const double unit = std::nextafter(std::abs(x), HUGE_VAL) - std::abs(x);
    return x + (static_cast<double>(random % 9) - 4) * unit;
  }

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
    std::erase_if(near_, [&](const Near& n) { return n.distance.low > limit() || is_thin(*n.edge, p); });
  }

  /// Whether the region on one side of the edge is thinner there than `thin`: another edge of its boundary is as near,
  /// at the place next to p and a little on from there.
  bool is_thin(const ZoneObjects::Edge& e, const Point& p) const {
    if (bounds_.thin == 0 || !e.of_region) return false;
    const double x = e.b.x - e.a.x, y = e.b.y - e.a.y;
    const double t = std::clamp(((p.x - e.a.x) * x + (p.y - e.a.y) * y) / (x * x + y * y), 0.0, 1.0);
    const Point here = at(e, t), on = at(e, t < 0.5 ? t + 0.01 : t - 0.01);
    bool found = false;
    const auto limit = [&] { return bounds_.thin; };
    zones_.objects.tree.near(here, limit, [&](std::uint32_t k) {
      const ZoneObjects::Edge& other = zones_.objects.edges[k];
      if (&other == &e || !other.of_region || other.object != e.object) return;
      found = found || (estimated_distance(here, other).low <= bounds_.thin &&
                        estimated_distance(on, other).low <= bounds_.thin);
    });
    return found;
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
    if (others.high < HUGE_VAL) {
      const double excess = (mine.low + mine.high) / 2 - (others.low + others.high) / 2;
      measures_.epsilon = std::max(measures_.epsilon, excess);
    }
    if (own_.empty()) return fail("row " + std::to_string(own) + " has no object", p);
    if (!is_surely_within(mine, others) && !is_exactly_within(p, mine, !holders.empty()))
      fail("object " + std::to_string(own) + " is further than another one by " +
               std::to_string((mine.high - others.low) / bounds_.epsilon) + " epsilon",
           p);
    if (mine.high * (1 + 0x1p-50) > bounds_.upper && squared_distance_of(p, mine) > squared(Rational(bounds_.upper)))
      fail("a place of row " + std::to_string(own) + " is further than the largest distance", p);
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

  bool is_exactly_within(const Point& p, const Interval& mine, bool is_held) {
    ++measures_.exactly;
    const Rational square = squared_distance_of(p, mine), epsilon(bounds_.epsilon);
    if (is_held) return root_is_within(square, 0, epsilon);
    return std::all_of(near_.begin(), near_.end(), [&](const Near& n) {
      return is_surely_within(mine, n.distance) ||
             root_is_within(square, squared_distance(RationalPoint(p), n.edge->a, n.edge->b), epsilon);
    });
  }

  /// With a largest distance: a place of the frame in no row.
  void check_far(const Point& p, const std::vector<std::uint32_t>& holders) {
    if (bounds_.lower == HUGE_VAL) return;
    const bool is_in_frame = std::any_of(frame_.areas.begin(), frame_.areas.end(),
                                         [&](const Area& area) { return area.where(p) == Area::Where::inside; });
    if (!is_in_frame || is_beside_frame(p)) return;
    find_near(p, 0);
    const bool is_near = !holders.empty() || std::any_of(near_.begin(), near_.end(), [&](const Near& n) {
      return n.distance.low < bounds_.lower &&
             squared_distance(RationalPoint(p), n.edge->a, n.edge->b) < squared(Rational(bounds_.lower));
    });
    if (is_near) fail("a place nearer than the largest distance is in no row", p);
  }

  /// As near to the frame's edges as rounding may have moved them.
  bool is_beside_frame(const Point& p) const {
    return std::any_of(frame_.areas.begin(), frame_.areas.end(), [&](const Area& area) {
      return std::any_of(area.edges().begin(), area.edges().end(), [&](const Stroke& e) {
        return bounds_.thin > 0 && estimated_distance(p, e).low <= bounds_.thin;
      });
    });
  }

  void fail(const std::string& what, const Point& p) {
    if (!fault_) fault_ = Fault{what + ", at " + to_text(p), {}};
  }

  const JudgedZones& zones_;
  const ZoneDistanceBounds& bounds_;
  std::vector<Stroke> borders_;
  NumberedAreas rows_, frame_;
  Box frame_box_;
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
