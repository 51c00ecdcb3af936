#include "verify/voronoi.h"

#include <algorithm>
#include <cmath>
#include <string>

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

class Comparison {
 public:
  Comparison(const Box& box, double tolerance) : box_(box), tolerance_(tolerance) {}

  /// Every vertex of the cell is found, and what else is found is as near to the cell's edges as rounding takes
  /// vertices of neighbours.
  bool are_equal(std::span<const Point> found, std::span<const Point> expected) const {
    if (found.empty() || expected.empty()) return found.empty() == expected.empty();
    return std::all_of(expected.begin(), expected.end(),
                       [&](const Point& v) { return is_found(v, found, expected); }) &&
           std::all_of(found.begin(), found.end(), [&](const Point& p) { return is_beside(p, expected); });
  }

 private:
  bool is_found(const Point& v, std::span<const Point> found, std::span<const Point> expected) const {
    // A vertex within a few roundings of another one may have been moved to it.
    const bool crowded = std::any_of(expected.begin(), expected.end(), [&](const Point& other) {
      return other != v && std::max(std::abs(other.x - v.x), std::abs(other.y - v.y)) <= 8 * tolerance_;
    });
    return std::any_of(found.begin(), found.end(), [&](const Point& p) {
      return p == v || ((crowded || is_on_box(v)) && std::max(std::abs(p.x - v.x), std::abs(p.y - v.y)) <= tolerance_);
    });
  }

  bool is_on_box(const Point& p) const {
    return p.x == box_.low.x || p.x == box_.high.x || p.y == box_.low.y || p.y == box_.high.y;
  }

  bool is_beside(const Point& p, std::span<const Point> cell) const {
    for (std::size_t i = 0; i < cell.size(); ++i)
      if (squared_distance(RationalPoint(p), cell[i], cell[(i + 1) % cell.size()]) <=
          Rational(tolerance_) * Rational(tolerance_))
        return true;
    return false;
  }

  const Box& box_;
  double tolerance_;
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
  const Comparison comparison(box, tolerance);
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
