#include "verify/buffer_zone.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "verify/predicates.h"
#include "verify/rational.h"

namespace oblast::verify {
namespace {

using Segment = ZoneOf::Segment;

std::string text(const Point& p) {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "(%.17g, %.17g)", p.x, p.y);
  return buffer;
}

double distance(const Point& p, const Segment& s) {
  const double ex = s.b.x - s.a.x, ey = s.b.y - s.a.y, dx = p.x - s.a.x, dy = p.y - s.a.y;
  const double along = dx * ex + dy * ey, length_2 = ex * ex + ey * ey;
  if (along <= 0 || length_2 == 0) return std::sqrt(dx * dx + dy * dy);
  const double fx = p.x - s.b.x, fy = p.y - s.b.y;
  if (along >= length_2) return std::sqrt(fx * fx + fy * fy);
  return std::fabs(dx * ey - dy * ex) / std::sqrt(length_2);
}

bool crosses(const Segment& s, const Segment& t) {
  const int a = side_of_line(s.a, s.b, t.a), b = side_of_line(s.a, s.b, t.b);
  const int c = side_of_line(t.a, t.b, s.a), d = side_of_line(t.a, t.b, s.b);
  return a * b < 0 && c * d < 0;
}

std::vector<Segment> edges_of(const RegionView& regions) {
  std::vector<Segment> edges;
  for (const std::span<const Point> contour : regions.contours())
    for (std::size_t i = 0; i < contour.size(); ++i) edges.push_back({contour[i], contour[(i + 1) % contour.size()]});
  return edges;
}

enum class Where { outside, on, inside };

/// By the winding number of a closed set.
Where where(const Point& p, std::span<const Segment> edges) {
  int winding = 0;
  for (const Segment& e : edges) {
    if (std::min(e.a.y, e.b.y) > p.y || std::max(e.a.y, e.b.y) < p.y) continue;
    const int side = side_of_line(e.a, e.b, p);
    if (side == 0 && std::min(e.a.x, e.b.x) <= p.x && p.x <= std::max(e.a.x, e.b.x)) return Where::on;
    if (e.a.y <= p.y && e.b.y > p.y && side > 0) ++winding;
    if (e.a.y > p.y && e.b.y <= p.y && side < 0) --winding;
  }
  return winding == 0 ? Where::outside : Where::inside;
}

class ZoneCheck {
 public:
  ZoneCheck(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds, bool inward)
      : zone_(edges_of(zone)), region_(edges_of(shapes.regions)), bounds_(bounds), inward_(inward) {
    features_ = region_;
    inner_features_ = bounds.holds_lines ? region_.size() + shapes.segments.size() : region_.size();
    features_.insert(features_.end(), shapes.segments.begin(), shapes.segments.end());
    for (const std::vector<Segment>* edges : {&zone_, &features_})
      for (const Segment& e : *edges)
        for (const double x : {e.a.x, e.a.y, e.b.x, e.b.y}) largest_ = std::max(largest_, std::fabs(x));
  }

  std::optional<Fault> run(ZoneDistances* distances) {
    for (const Segment& e : zone_) {
      check_nearest(e);
      if (fault_) return fault_;
      check_furthest(e);
      if (fault_) return fault_;
    }
    check_vertices();
    if (!fault_) check_samples();
    if (distances) *distances = {zone_.empty() ? 0 : nearest_, furthest_};
    return fault_;
  }

 private:
  void fail(const std::string& what) {
    if (!fault_) fault_ = Fault{what, {}};
  }

  /// The sign of distance - bound.
  int compare(const Point& p, const Segment& s, double bound) const {
    const double found = distance(p, s);
    if (std::fabs(found - bound) > 1e-13 * (largest_ + bound)) return found < bound ? -1 : 1;
    const Rational exact = squared_distance(RationalPoint(p), s.a, s.b), limit = Rational(bound) * Rational(bound);
    return exact < limit ? -1 : exact > limit ? 1 : 0;
  }

  /// True if the place counts as distance 0: in the region, or, for inner zones, out of it.
  bool is_in_shape(const Point& p) const {
    if (region_.empty()) return inward_;
    const Where found = where(p, region_);
    return inward_ ? found != Where::inside : found != Where::outside;
  }

  /// True if the zone must hold the segment.
  bool is_inner(const Segment& s) const { return &s < features_.data() + inner_features_; }

  const Segment* nearest_to(const Point& p) const {
    const Segment* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Segment& s : features_) {
      const double found = distance(p, s);
      if (found < least) least = found, nearest = &s;
    }
    return nearest;
  }

  bool is_within(const Point& p, double bound) const {
    return std::any_of(features_.begin(), features_.end(), [&](const Segment& s) { return compare(p, s, bound) <= 0; });
  }

  void check_nearest(const Segment& e) {
    if (is_in_shape(e.a) && bounds_.lower > 0 && bounds_.check_lower)
      return fail("a vertex of the outline lies in the shapes: " + text(e.a));
    for (const Segment& s : features_) {
      if (is_inner(s) && bounds_.slack == 0 && crosses(e, s))
        return fail("the outline crosses the shapes at the edge from " + text(e.a) + " to " + text(e.b));
      const double found = std::min({distance(e.a, s), distance(e.b, s), distance(s.a, e), distance(s.b, e)});
      nearest_ = std::min(nearest_, found);
      if (!bounds_.check_lower || found > bounds_.lower * (1 + 1e-9) + 1e-9 * largest_) continue;
      const double bound = bounds_.lower;
      if (bound > 0 && (compare(e.a, s, bound) < 0 || compare(e.b, s, bound) < 0 || compare(s.a, e, bound) < 0 ||
                        compare(s.b, e, bound) < 0))
        return fail("the outline is too near to the shapes, at " + text({found, bound}) + " (distance, bound): edge " +
                    text(e.a) + " to " + text(e.b) + ", shape " + text(s.a) + " to " + text(s.b));
    }
  }

  /// The distance from one segment is convex along an edge, so it is enough if both ends are near to the same one.
  void check_furthest(const Segment& e) {
    std::vector<Segment> open{e};
    for (int steps = 0; !open.empty(); ++steps) {
      const Segment part = open.back();
      open.pop_back();
      if (features_.empty()) return fail("there is a zone, but no shapes");
      for (const Point& p : {part.a, part.b}) {
        if (is_in_shape(p)) continue;
        const Segment& nearest = *nearest_to(p);
        furthest_ = std::max(furthest_, distance(p, nearest));
        const bool is_near = compare(p, nearest, bounds_.upper) <= 0 || is_within(p, bounds_.upper);
        if (!is_near)
          return fail("the outline is too far from the shapes, by " +
                      std::to_string(distance(p, nearest) / bounds_.upper) + " of the bound, at " + text(p));
      }
      const bool near_one = std::any_of(features_.begin(), features_.end(), [&](const Segment& s) {
        return compare(part.a, s, bounds_.upper) <= 0 && compare(part.b, s, bounds_.upper) <= 0;
      });
      const Point middle{part.a.x + (part.b.x - part.a.x) / 2, part.a.y + (part.b.y - part.a.y) / 2};
      if (near_one || middle == part.a || middle == part.b || steps > 1000) continue;
      open.push_back({part.a, middle});
      open.push_back({middle, part.b});
    }
  }

  void check_vertices() {
    for (const Segment& s : std::span(features_).first(inner_features_))
      for (const Point& p : {s.a, s.b}) {
        const Where found = where(p, zone_);
        const bool is_wrong = inward_ ? found == Where::inside : found == Where::outside;
        const bool is_excused = bounds_.slack > 0 && std::any_of(zone_.begin(), zone_.end(), [&](const Segment& e) {
                                  return distance(p, e) <= bounds_.slack;
                                });
        if (is_wrong && !is_excused)
          return fail("a vertex of the shapes is on the wrong side of the outline: " + text(p));
      }
  }

  void check_sample(const Point& p) {
    if (!in_domain(p.x) || !in_domain(p.y)) return;
    const bool in_shape = is_in_shape(p);
    const Segment* const nearest = nearest_to(p);
    const double margin = 1e-12 * largest_;
    const double away = in_shape ? 0 : nearest ? distance(p, *nearest) : std::numeric_limits<double>::infinity();
    const Where found = where(p, zone_);
    const bool in_zone = inward_ ? found != Where::inside : found != Where::outside;
    const bool out_of_zone = inward_ ? found != Where::outside : found != Where::inside;
    if (bounds_.check_lower && away < bounds_.lower - margin && !in_zone)
      fail("a place at the distance " + std::to_string(away) + " is on the wrong side of the outline: " + text(p));
    if (away > bounds_.upper + margin && !out_of_zone)
      fail("a place at the distance " + std::to_string(away) + ", beyond the bound, counts as near: " + text(p));
  }

  void check_samples() {
    if (features_.empty()) return;
    std::mt19937_64 random(bounds_.seed);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto vertex = [&] { return features_[random() % features_.size()].a; };
    Point low = features_[0].a, high = low;
    for (const Segment& s : features_)
      for (const Point& p : {s.a, s.b})
        low = {std::min(low.x, p.x), std::min(low.y, p.y)}, high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    const double margin = 1.5 * bounds_.upper;
    for (std::uint32_t k = 0; k < bounds_.samples && !fault_; ++k) {
      check_sample({low.x - margin + (high.x - low.x + 2 * margin) * unit(),
                    low.y - margin + (high.y - low.y + 2 * margin) * unit()});
      const Point p = vertex(), q = vertex(), r = vertex();
      check_sample({p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2});
      const double angle = 6.283185307179586 * unit(), away = bounds_.upper * (0.8 + 0.4 * unit());
      check_sample({p.x + away * std::cos(angle), p.y + away * std::sin(angle)});
      const double qx = q.x - p.x, qy = q.y - p.y, rx = r.x - p.x, ry = r.y - p.y, twice = 2 * (qx * ry - qy * rx);
      const double q2 = qx * qx + qy * qy, r2 = rx * rx + ry * ry;
      if (twice != 0) check_sample({p.x + (ry * q2 - qy * r2) / twice, p.y + (qx * r2 - rx * q2) / twice});
    }
  }

  std::vector<Segment> zone_, region_, features_;
  std::size_t inner_features_ = 0;  ///< the first of these are in the zone
  const ZoneBounds& bounds_;
  bool inward_;
  double largest_ = 0;
  double nearest_ = std::numeric_limits<double>::infinity(), furthest_ = 0;
  std::optional<Fault> fault_;
};

}  // namespace

std::optional<Fault> check_zone(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds,
                                ZoneDistances* distances) {
  return ZoneCheck(zone, shapes, bounds, false).run(distances);
}

std::optional<Fault> check_inner_zone(const RegionView& zone, const ZoneOf& shapes, const ZoneBounds& bounds,
                                      ZoneDistances* distances) {
  return ZoneCheck(zone, shapes, bounds, true).run(distances);
}

}  // namespace oblast::verify
