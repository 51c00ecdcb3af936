#include "noding/clearance.h"

#include <algorithm>
#include <cmath>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/largest_ulp.h"

namespace oblast::internal::noding {
namespace {

/// At most the distance of p from q, at least 0.7 times that.
double short_distance(const Point& p, const Point& q) { return std::max(std::fabs(p.x - q.x), std::fabs(p.y - q.y)); }

double length_bound(const Point& p) { return std::fabs(p.x) + std::fabs(p.y); }

}  // namespace

Clearance::Clearance(Strands& strands) : strands_(strands) {
  constexpr std::size_t points_a_range = tuning::clearance_points_a_range;
  const std::span<const Point> points = strands.points;
  if (points.size() <= points_a_range) {
    distance_ = clear_ulps * ulp_of(largest_coordinate(points));
    return;
  }
  Array<double> largest(range_count(points.size(), points_a_range));
  for_numbered_ranges(points.size(), points_a_range, [&](std::size_t i, std::size_t begin, std::size_t end) {
    largest[i] = largest_coordinate(points.subspan(begin, end - begin));
  });
  distance_ = clear_ulps * ulp_of(*std::max_element(largest.begin(), largest.end()));
}

float Clearance::sine_at(const Point& p, const Point& u, const Point& v) const {
  const Point out{u.x - p.x, u.y - p.y}, other{v.x - p.x, v.y - p.y};
  const double shorter = std::min(short_distance(u, p), short_distance(v, p));
  const double bound = length_bound(out) * length_bound(other);
  // Both are above what the rounding of the products could make of nothing.
  constexpr double safe = 0x1p-30;
  if (out.x * other.x + out.y * other.y < -safe * bound) return shorter > distance_ ? 1.0F : 0.0F;
  const double sine = std::fabs(out.x * other.y - out.y * other.x) / bound * (1 - 0x1p-18);
  return sine > safe && shorter * sine > distance_ ? static_cast<float>(sine) : 0.0F;
}

void Clearance::look_along(std::size_t strand, std::span<const EdgeContact> contacts) {
  const auto& points = strands_.points;
  const std::uint32_t edge = contacts[0].edge, first = strands_.begin(strand), last = strands_.ends[strand] - 1;
  for (std::size_t k = 1; k < contacts.size(); ++k) {
    const EdgeContact &p = contacts[k - 1], &q = contacts[k];
    if (!(short_distance(p.at, q.at) * std::min<double>(p.sine, q.sine) > distance_)) return flag(edge);
  }
  const Point &a = points[edge], &b = points[edge + 1];
  std::span<const EdgeContact> cuts = contacts;
  if (cuts.front().at == a) cuts = cuts.subspan(1);
  if (!cuts.empty() && cuts.back().at == b) cuts = cuts.first(cuts.size() - 1);
  if (cuts.empty()) return;
  // The cuts nearest to the ends, against the neighbours there.
  const bool closed = (strands_.load_flags(first) & closed_flag) != 0;
  if (edge > first || closed) {
    const Point& before = points[edge > first ? edge - 1 : last - 1];
    if (!(short_distance(a, cuts.front().at) * sine_at(a, b, before) > distance_)) return flag(edge);
  }
  if (edge + 1 < last || closed) {
    const Point& after = points[edge + 1 < last ? edge + 2 : first + 1];
    if (!(short_distance(b, cuts.back().at) * sine_at(b, a, after) > distance_)) return flag(edge);
  }
}

}  // namespace oblast::internal::noding
