#include <oblast/measure.h>

#include <algorithm>
#include <cmath>

#include "base/public_call.h"
#include "regions/ring_area.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
namespace {

/// Of each contour by itself, so that the sum has the same terms whatever the threads.
Array<double> contour_areas(const RegionView& regions) {
  Array<double> areas(regions.contour_count());
  for_ranges(areas.size(), tuning::measured_contours_a_task, [&](std::size_t c, std::size_t end) {
    for (; c < end; ++c) {
      CompensatedSum sum;
      add_ring_area(regions.contour(c), sum);
      areas[c] = std::fabs(sum.value());
    }
  });
  return areas;
}

double area_of(const RegionView& regions) {
  const Array<double> areas = contour_areas(regions);
  CompensatedSum sum;
  for (std::size_t p = 0; p < regions.polygon_count(); ++p)
    for (std::uint32_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c)
      sum.add(c == regions.polygon_begin(p) ? areas[c] : -areas[c]);
  return sum.value();
}

std::optional<oblast::Box> bounds_of(std::span<const Point> points) {
  if (points.empty()) return {};
  oblast::Box box{points[0].x, points[0].y, points[0].x, points[0].y};
  for (const Point& p : points) {
    box.x0 = std::min(box.x0, p.x), box.x1 = std::max(box.x1, p.x);
    box.y0 = std::min(box.y0, p.y), box.y1 = std::max(box.y1, p.y);
  }
  return oblast::Box{box.x0 + 0.0, box.y0 + 0.0, box.x1 + 0.0, box.y1 + 0.0};  // -0.0 becomes 0.0
}

}  // namespace

double area(const RegionView& regions, const CallOptions& options) {
  return public_call(options, regions.points.size(), [&](Control&) {
    validate(regions, 0);
    return area_of(regions);
  });
}

std::optional<oblast::Box> bounds(const RegionView& regions, const CallOptions& options) {
  return public_call(options, regions.points.size(), [&](Control&) {
    validate(regions, 0);
    return bounds_of(regions.points);
  });
}

}  // namespace oblast
