#include "verify/voronoi.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "verify/distance.h"
#include "verify/edges.h"
#include "verify/rows.h"

namespace oblast::verify {
namespace {

using Ring = std::vector<RationalPoint>;

/// The part of a convex ring that is not further from p than from q.
Ring nearer(const Ring& ring, const Point& p, const Point& q) {
  const RationalPoint from(p), to(q);
  const Rational nx = 2 * (to.x - from.x), ny = 2 * (to.y - from.y);
  const Rational level = to.x * to.x + to.y * to.y - from.x * from.x - from.y * from.y;
  std::vector<Rational> beyond;  // by vertex: above 0 if it is nearer to q
  for (const RationalPoint& v : ring) beyond.push_back(nx * v.x + ny * v.y - level);
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = (i + 1) % ring.size();
    if (beyond[i] <= 0) kept.push_back(ring[i]);
    if (beyond[i].sign() * beyond[j].sign() >= 0) continue;
    const Rational t = beyond[i] / (beyond[i] - beyond[j]);
    kept.emplace_back(ring[i].x + t * (ring[j].x - ring[i].x), ring[i].y + t * (ring[j].y - ring[i].y));
  }
  return kept;
}

Rational twice_area(const Ring& ring) {
  Rational sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RationalPoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

std::vector<Point> rounded(const Ring& ring) {
  std::vector<Point> points;
  for (const RationalPoint& v : ring) {
    const Point p{round_into_domain(v.x), round_into_domain(v.y)};
    if (points.empty() || points.back() != p) points.push_back(p);
  }
  while (points.size() > 1 && points.back() == points.front()) points.pop_back();
  if (points.size() < 3) points.clear();
  return points;
}

/// Compares rows with exact cells. Where vertices are nearer to each other than `tolerance`, rounding may make edges
/// cross and noding may part them again, so there the outline must be as near, but need not have the same vertices.
class Comparison {
 public:
  Comparison(const Box& box, double tolerance, const std::vector<Ring>& cells) : box_(box), tolerance_(tolerance) {
    for (const Ring& cell : cells)
      for (const Point& p : rounded(cell)) vertices_.push_back(p);
  }

  bool are_equal(std::span<const Point> found, std::span<const Point> expected) const {
    if (found.empty() != expected.empty()) return false;
    const auto is_found = [&](const Point& v) {
      return std::any_of(found.begin(), found.end(), [&](const Point& p) {
        return p == v || (may_move(v) && is_near(p, {v, v}));
      });
    };
    const auto is_expected = [&](const Point& p) {
      for (std::size_t i = 0; i < expected.size(); ++i)
        if (p == expected[i] || is_near(p, {expected[i], expected[(i + 1) % expected.size()]})) return true;
      return false;
    };
    return std::all_of(expected.begin(), expected.end(), is_found) &&
           std::all_of(found.begin(), found.end(), is_expected);
  }

 private:
  bool is_near(const Point& p, const Stroke& edge) const {
    const Interval found = estimated_distance(p, edge);
    if (found.high < tolerance_ || found.low > tolerance_) return found.high < tolerance_;
    return squared_distance(RationalPoint(p), edge.a, edge.b) <= Rational(tolerance_) * Rational(tolerance_);
  }

  bool may_move(const Point& v) const {
    if (v.x == box_.low.x || v.x == box_.high.x || v.y == box_.low.y || v.y == box_.high.y) return true;
    return std::any_of(vertices_.begin(), vertices_.end(), [&](const Point& other) {
      return other != v && is_near(other, {v, v});
    });
  }

  const Box& box_;
  double tolerance_;
  std::vector<Point> vertices_;
};

}  // namespace

std::vector<std::vector<RationalPoint>> voronoi_cells(std::span<const Point> points, const Box& box) {
  std::vector<Ring> cells(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point corners[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    Ring cell;
    for (const Point& corner : corners) cell.emplace_back(corner);
    for (std::size_t j = 0; j < points.size() && !cell.empty(); ++j) {
      if (points[j] == points[i] && j < i) cell.clear();
      if (points[j] != points[i]) cell = nearer(cell, points[i], points[j]);
    }
    if (!cell.empty() && twice_area(cell) > 0) cells[i] = std::move(cell);
  }
  return cells;
}

std::optional<Fault> check_voronoi(std::span<const Point> points, const Box& box, const FeatureView& rows,
                                   double tolerance) {
  if (rows.feature_count() != points.size()) return Fault{"there is not a row for each point", {}};
  const std::vector<Ring> cells = voronoi_cells(points, box);
  const Comparison comparison(box, tolerance, cells);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RegionView row = regions_of(rows, i);
    const std::vector<Point> expected = rounded(cells[i]);
    if (row.contour_count() > 1) return Fault{"the zone of point " + std::to_string(i) + " is not one contour", {}};
    if (comparison.are_equal(row.points, expected)) continue;
    std::string what = "the zone of point " + std::to_string(i) + " is not its Voronoi cell: ";
    for (const Point& p : row.points) what += to_text(p) + " ";
    what += "in place of ";
    for (const Point& p : expected) what += to_text(p) + " ";
    return Fault{what, {}};
  }
  return {};
}

}  // namespace oblast::verify
