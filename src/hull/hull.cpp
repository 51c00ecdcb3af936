// The public hulls: Lee's scan, its answer checked; region sets by the hulls of their contours.
#include <oblast/hull.h>

#include <algorithm>

#include "exact/orientation.h"
#include "hull/lee.h"
#include "overlay/validate.h"

namespace oblast {
namespace {

using exact::orientation;

/// Without repeated neighbours and without a closing point; -0.0 becomes 0.0.
std::vector<Point> cleaned(std::span<const Point> contour) {
  std::vector<Point> ring;
  ring.reserve(contour.size());
  for (const Point& p : contour) {
    const Point q{p.x + 0.0, p.y + 0.0};
    if (ring.empty() || ring.back() != q) ring.push_back(q);
  }
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  return ring;
}

/// The turn at the smallest vertex: the direction of a simple ring, and never 0 for one.
int direction(std::span<const Point> ring) {
  const auto smallest =
      static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), lexicographically_less) - ring.begin());
  const std::size_t n = ring.size();
  return orientation(ring[(smallest + n - 1) % n], ring[smallest], ring[(smallest + 1) % n]);
}

/// One side of a hull, from the smallest corner to the largest. Tells of any point between them on which side
/// of it the point lies; remembers where the last one was, as neighbours on a contour are near.
class HullSide {
 public:
  explicit HullSide(std::vector<Point> corners) : corners_(std::move(corners)) {}

  bool turns(int turn) const {
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
      if (!lexicographically_less(corners_[i], corners_[i + 1])) return false;
      if (i > 0 && orientation(corners_[i - 1], corners_[i], corners_[i + 1]) != turn) return false;
    }
    return true;
  }

  /// REQUIRES: p between the smallest and the largest corner, or one of them.
  int side_of(const Point& p) {
    const auto holds = [&](std::size_t i) {
      return !lexicographically_less(p, corners_[i]) && !lexicographically_less(corners_[i + 1], p);
    };
    const std::size_t edges = corners_.size() - 1;
    if (holds(edge_)) {
    } else if (edge_ + 1 < edges && holds(edge_ + 1)) {
      ++edge_;
    } else if (edge_ > 0 && holds(edge_ - 1)) {
      --edge_;
    } else {
      const auto after = std::upper_bound(corners_.begin(), corners_.end(), p, lexicographically_less);
      edge_ = std::min(static_cast<std::size_t>(after - corners_.begin()), edges) - 1;
    }
    return orientation(corners_[edge_], corners_[edge_ + 1], p);
  }

 private:
  std::vector<Point> corners_;
  std::size_t edge_ = 0;
};

/// True when `hull`, clockwise from its smallest corner, is strictly convex and holds all points of the ring.
bool is_hull_of(std::span<const Point> hull, std::span<const Point> ring) {
  if (hull.size() < 3) return false;
  const auto largest = std::max_element(hull.begin(), hull.end(), lexicographically_less);
  HullSide upper({hull.begin(), largest + 1});
  std::vector<Point> below(largest, hull.end());
  below.push_back(hull.front());
  std::reverse(below.begin(), below.end());
  HullSide lower(std::move(below));
  if (!upper.turns(-1) || !lower.turns(1)) return false;
  // Above the line from the smallest to the largest corner only the upper side can leave a point out.
  return std::all_of(ring.begin(), ring.end(), [&](const Point& p) {
    return orientation(hull.front(), *largest, p) > 0 ? upper.side_of(p) <= 0 : lower.side_of(p) >= 0;
  });
}

}  // namespace

std::vector<Point> hull(std::span<const Point> contour) {
  std::vector<Point> ring = cleaned(contour);
  if (ring.size() < 3) return monotone_chain_hull(ring);
  const int turn = direction(ring);
  if (turn > 0) std::reverse(ring.begin(), ring.end());
  std::vector<Point> corners = lee_hull(ring);
  if (turn == 0 || !is_hull_of(corners, ring)) return monotone_chain_hull(ring);
  std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

RegionSet hull(const RegionView& regions) {
  validate(regions, 0);
  std::vector<Point> corners;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const std::vector<Point> of_contour = hull(regions.contour(c));
    corners.insert(corners.end(), of_contour.begin(), of_contour.end());
  }
  RegionSet result;
  result.points = regions.contour_count() == 1 ? std::move(corners) : monotone_chain_hull(corners);
  if (result.points.size() < 3) return {};
  result.contour_ends = {static_cast<std::uint32_t>(result.points.size())};
  result.polygon_ends = {1};
  return result;
}

}  // namespace oblast
