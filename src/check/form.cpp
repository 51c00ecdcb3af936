#include "check/form.h"

#include <oblast/domain.h>

#include <cmath>

#include "base/index.h"
#include "base/parallel.h"
#include "base/tuning.h"

namespace oblast::internal::checking {
namespace {

bool increase_to(std::span<const std::uint32_t> ends, std::uint32_t first, std::size_t total) {
  std::uint32_t before = first;
  for (const std::uint32_t end : ends) {
    if (end <= before) return false;
    before = end;
  }
  return before == first + total;
}

std::optional<Finding> bad_coordinate(const RegionView& regions) {
  FirstFinding first;
  for_ranges(regions.points.size(), tuning::validated_points_a_range, [&](std::size_t v, std::size_t end) {
    for (; v < end; ++v) {
      const Point& p = regions.points[v];
      if (in_domain(p.x) && in_domain(p.y)) continue;
      const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
      first.offer({finite ? FaultKind::out_of_domain : FaultKind::not_finite, static_cast<std::uint32_t>(v), none, p});
    }
  });
  return first.get();
}

void look_at_contour(const RegionView& regions, std::size_t contour, FirstFinding& first) {
  const std::uint32_t begin = regions.contour_begin(contour), end = regions.contour_end(contour);
  if (end - begin < 3) first.offer({FaultKind::too_few_vertices, begin, none, regions.points[begin]});
  for (std::uint32_t v = begin; v < end; ++v) {
    const std::uint32_t next = v + 1 < end ? v + 1 : begin;
    if (next != v && regions.points[v] == regions.points[next])
      first.offer({FaultKind::repeated_vertex, v, next, regions.points[v]});
  }
}

}  // namespace

std::optional<const char*> find_bad_offsets(const RegionView& regions) {
  check_count(regions.contour_count(), "contours in one call");
  check_count(regions.polygon_count(), "polygons in one call");
  if (!increase_to(regions.contour_ends, regions.first_point, regions.points.size()))
    return "contour_ends must increase and end at the number of points: a contour is empty, or an end steps back";
  if (!regions.polygon_ends.empty() &&
      !increase_to(regions.polygon_ends, regions.first_contour, regions.contour_count()))
    return "polygon_ends must increase and end at the number of contours: a polygon is empty, or an end steps back";
  return {};
}

std::optional<Finding> find_bad_vertex(const RegionView& regions) {
  if (auto finding = bad_coordinate(regions)) return finding;
  FirstFinding first;
  const std::size_t contours = regions.contour_count();
  for_ranges(contours, grain(contours, regions.points.size()), [&](std::size_t contour, std::size_t end) {
    for (; contour < end; ++contour) look_at_contour(regions, contour, first);
  });
  return first.get();
}

}  // namespace oblast::internal::checking
