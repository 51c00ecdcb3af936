#include "check/order.h"

#include <algorithm>
#include <cmath>

#include "base/call_memory.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "plane/smallest_vertex.h"

namespace oblast::internal::checking {
namespace {

using Contour = std::span<const Point>;

/// As sequences of vertices; the first begins at its vertex `shift`.
bool comes_before(Contour p, Contour q, std::size_t shift = 0) {
  for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) {
    const Point& at = p[(i + shift) % p.size()];
    if (at != q[i]) return lexicographically_less(at, q[i]);
  }
  return p.size() < q.size();
}

std::optional<Finding> find_negative_zero(const RegionView& regions) {
  FirstFinding first;
  const auto is_negative_zero = [](double x) { return x == 0 && std::signbit(x); };
  for_ranges(regions.points.size(), tuning::validated_points_a_range, [&](std::size_t v, std::size_t end) {
    for (; v < end; ++v) {
      const Point& p = regions.points[v];
      if (is_negative_zero(p.x) || is_negative_zero(p.y))
        first.offer({FaultKind::negative_zero, static_cast<std::uint32_t>(v), none, p});
    }
  });
  return first.get();
}

/// The vertex at which a contour has to start.
std::size_t start_of(Contour contour) {
  const auto [smallest, repeated] = smallest_vertex(contour);
  std::size_t start = smallest;
  if (!repeated) return start;
  Array<Point> from_start(contour.begin() + smallest, contour.end());
  from_start.insert(from_start.end(), contour.begin(), contour.begin() + smallest);
  for (std::size_t v = start + 1; v < contour.size(); ++v) {
    if (contour[v] != contour[smallest] || !comes_before(contour, from_start, v)) continue;
    start = v;
    for (std::size_t i = 0; i < contour.size(); ++i) from_start[i] = contour[(i + v) % contour.size()];
  }
  return start;
}

std::optional<Finding> find_wrong_start(const RegionView& regions) {
  FirstFinding first;
  const std::size_t contours = regions.contour_count();
  for_ranges(contours, grain(contours, regions.points.size()), [&](std::size_t c, std::size_t end) {
    for (; c < end; ++c) {
      const auto start = static_cast<std::uint32_t>(start_of(regions.contour(c)));
      const std::uint32_t begin = regions.contour_begin(c);
      if (start != 0) first.offer({FaultKind::wrong_start, begin, begin + start, regions.points[begin]});
    }
  });
  return first.get();
}

/// The first vertices of two contours of which the second should be before the first.
Finding in_wrong_order(const RegionView& regions, FaultKind kind, std::uint32_t contour, std::uint32_t before) {
  const std::uint32_t v = regions.contour_begin(contour);
  return {kind, v, regions.contour_begin(before), regions.points[v]};
}

std::optional<Finding> find_wrong_order(const RegionView& regions) {
  FirstFinding first;
  for_ranges(regions.polygon_count(), tuning::measured_contours_a_task, [&](std::size_t p, std::size_t end) {
    for (; p < end; ++p) {
      const std::uint32_t outer = regions.polygon_begin(p), past = regions.polygon_end(p);
      const std::uint32_t outer_before = p > 0 ? regions.polygon_begin(p - 1) : outer;
      if (p > 0 && !comes_before(regions.contour(outer_before), regions.contour(outer)))
        first.offer(in_wrong_order(regions, FaultKind::polygons_out_of_order, outer, outer_before));
      for (std::uint32_t hole = outer + 2; hole < past; ++hole)
        if (!comes_before(regions.contour(hole - 1), regions.contour(hole)))
          first.offer(in_wrong_order(regions, FaultKind::holes_out_of_order, hole, hole - 1));
    }
  });
  return first.get();
}

}  // namespace

std::optional<Finding> find_bad_order(const RegionView& regions) {
  if (auto finding = find_negative_zero(regions)) return finding;
  if (auto finding = find_wrong_start(regions)) return finding;
  return find_wrong_order(regions);
}

}  // namespace oblast::internal::checking
