#include <oblast/measure.h>

#include <cmath>

#include "base/public_call.h"
#include "plane/box.h"
#include "regions/ring_area.h"
#include "regions/validate.h"

namespace oblast {
using namespace internal;
namespace {

/// The area of each contour separately. So the sum has the same terms on any number of threads.
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
  internal::Box box = internal::Box::of(points[0], points[0]);
  for (const Point& p : points) box = box.joined(p);
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
