// The public hull functions: Lee's scan with a check of its result; for region sets, the hull of the hulls of contours.
#include <oblast/hull.h>

#include <algorithm>

#include "base/call_memory.h"
#include "base/counting_sort.h"
#include "base/public_call.h"
#include "exact/orientation.h"
#include "hull/lee.h"
#include "noding/simple_ring.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
namespace {

using exact::orientation;

/// The contour without repeated neighbours and without a closing point.
Array<Point> cleaned(std::span<const Point> contour) {
  Array<Point> ring(contour.begin(), contour.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

/// One side of a hull, from the smallest corner to the largest. For any point between them, decides on which side of it
/// the point lies. Corners are found in buckets of equal width in x, as many as corners.
class HullSide {
 public:
  explicit HullSide(Array<Point> corners) : corners_(std::move(corners)), first_(corners_.size() + 1) {
    const double width = corners_.back().x - corners_.front().x;
    scale_ = width > 0 ? static_cast<double>(corners_.size()) / width : 0;
    count_begins(first_, [&](const auto& visit) {
      for (const Point& c : corners_) visit(bucket(c), c);
    });
  }

  bool turns(int turn) const {
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
      if (!lexicographically_less(corners_[i], corners_[i + 1])) return false;
      if (i > 0 && orientation(corners_[i - 1], corners_[i], corners_[i + 1]) != turn) return false;
    }
    return true;
  }

  /// REQUIRES: p is between the smallest and the largest corner, or equals one of them.
  int side_of(const Point& p) const {
    const std::size_t b = bucket(p);
    // Rounding is monotone: corners in smaller (larger) buckets have a smaller (larger) x than p.
    const auto after =
        std::upper_bound(corners_.begin() + first_[b], corners_.begin() + first_[b + 1], p, lexicographically_less);
    const auto edge = std::min(after, corners_.end() - 1) - 1;
    return orientation(edge[0], edge[1], p);
  }

 private:
  std::size_t bucket(const Point& p) const {
    return std::min(static_cast<std::size_t>((p.x - corners_.front().x) * scale_), corners_.size() - 1);
  }

  Array<Point> corners_;
  Array<std::ptrdiff_t> first_;  ///< by bucket: its first corner
  double scale_ = 0;
};

/// True if `hull`, counter-clockwise from its smallest corner, is strictly convex and contains all points of the ring.
bool is_hull_of(std::span<const Point> hull, std::span<const Point> ring) {
  if (hull.size() < 3) return false;
  const auto largest = std::max_element(hull.begin(), hull.end(), lexicographically_less);
  const HullSide lower({hull.begin(), largest + 1});
  Array<Point> above(largest, hull.end());
  above.push_back(hull.front());
  std::reverse(above.begin(), above.end());
  const HullSide upper(std::move(above));
  if (!upper.turns(-1) || !lower.turns(1)) return false;
  // Above the line from the smallest to the largest corner, only the upper side can exclude a point.
  return std::all_of(ring.begin(), ring.end(), [&](const Point& p) {
    return orientation(hull.front(), *largest, p) > 0 ? upper.side_of(p) <= 0 : lower.side_of(p) >= 0;
  });
}

/// The corners of the hull of one contour.
Array<Point> hull_of(std::span<const Point> contour) {
  while (contour.size() > 1 && contour.back() == contour.front()) contour = contour.first(contour.size() - 1);
  Array<Point> copy;
  if (std::adjacent_find(contour.begin(), contour.end()) != contour.end()) {
    copy = cleaned(contour);
    contour = copy;
  }
  Array<Point> corners;
  const int turn = contour.size() < 3 ? 0 : turn_at_smallest(contour);
  if (turn != 0) corners = lee_hull(contour, turn);
  if (turn == 0 || !is_hull_of(corners, contour)) {
    Array<Point> points(contour.begin(), contour.end());
    corners = monotone_chain_hull(points);
  }
  for (Point& p : corners) p = {p.x + 0.0, p.y + 0.0};  // -0.0 becomes 0.0
  return corners;
}

Array<Point> hull_of(const RegionView& regions) {
  if (regions.contour_count() == 1) return hull_of(regions.contour(0));
  Array<Point> corners;
  Steps steps(regions.contour_count(), tuning::contours_a_poll);
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    steps();
    const Array<Point> of_contour = hull_of(regions.contour(c));
    corners.insert(corners.end(), of_contour.begin(), of_contour.end());
  }
  return monotone_chain_hull(corners);
}

}  // namespace

std::vector<Point> hull(std::span<const Point> contour, const CallOptions& options) {
  return public_call(options, contour.size(), [&](Control&) {
    validate(contour);
    const Array<Point> corners = hull_of(contour);
    const Charge charge(corners.size() * sizeof(Point));
    return std::vector<Point>(corners.begin(), corners.end());
  });
}

RegionSet hull(const RegionView& regions, const CallOptions& options) {
  return public_call(options, regions.points.size(), [&](Control&) {
    validate(regions, 0);
    const Array<Point> corners = hull_of(regions);
    if (corners.size() < 3) return RegionSet{};
    const Charge charge(bytes_of_regions(corners.size(), 1, 1));
    return RegionSet{{corners.begin(), corners.end()}, {static_cast<std::uint32_t>(corners.size())}, {1}};
  });
}

}  // namespace oblast
