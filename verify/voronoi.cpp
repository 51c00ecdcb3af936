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

  bool are_equal(std::span<const Point> found, std::span<const Point> expected) const {
    if (found.size() != expected.size()) return false;
    for (std::size_t turn = 0; turn < found.size(); ++turn) {
      bool equal = true;
      for (std::size_t i = 0; i < found.size() && equal; ++i)
        equal = are_equal(found[(i + turn) % found.size()], expected[i]);
      if (equal) return true;
    }
    return found.empty();
  }

 private:
  bool are_equal(const Point& found, const Point& expected) const {
    if (found == expected) return true;
    const bool on_side = found.x == expected.x && (found.x == box_.low.x || found.x == box_.high.x);
    const bool on_level = found.y == expected.y && (found.y == box_.low.y || found.y == box_.high.y);
    return (on_side && std::abs(found.y - expected.y) <= tolerance_) ||
           (on_level && std::abs(found.x - expected.x) <= tolerance_);
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
