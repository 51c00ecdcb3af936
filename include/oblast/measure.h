// The area and the bounding box of regions. `signed_area` is in region_set.h.
#pragma once

#include <oblast/error.h>
#include <oblast/export.h>
#include <oblast/options.h>
#include <oblast/region_set.h>

#include <optional>

namespace oblast {

/// A rectangle with sides along the axes: x0 <= x <= x1, y0 <= y <= y1.
struct Box {
  double x0, y0, x1, y1;

  friend constexpr bool operator==(const Box&, const Box&) = default;
};

/// The sum of the areas of the polygons, in squared units of the coordinates. The area of a polygon is the area of its
/// first contour minus the areas of its other contours. The direction of contours does not matter. For the result of an
/// overlay this is the area of its regions. Polygons are not united first: an area that two polygons cover counts
/// twice. If a contour crosses itself, each part of it counts with its winding number. Call `unite` first if the input
/// may overlap or cross itself.
/// Cost: linear. The accuracy is that of `signed_area`. The number of threads does not change the value.
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit.
OBLAST_API double area(const RegionView& regions, const CallOptions& options = {});

/// The smallest rectangle that contains all points, exactly; nothing if there are no points. Cost: linear.
/// Throws Error: as `area`.
OBLAST_API std::optional<Box> bounds(const RegionView& regions, const CallOptions& options = {});

}  // namespace oblast
