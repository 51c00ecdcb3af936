// What regions measure: their area and their bounds. `signed_area` is in region_set.h.
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

/// The area of the polygons, in squared units of the coordinates, 0 or more for any result of an overlay: of each
/// polygon what its first contour encloses, less what the others do, whichever way they run. So polygons that overlap
/// count twice, and contours that cross themselves by their winding numbers; `unite` comes first where that may be.
/// Cost: linear. In doubles, as exact as `signed_area`, and the same on any number of threads.
/// Throws Error: not_finite, out_of_domain, too_large, bad_offsets, bad_option, cancelled, memory_limit.
OBLAST_API double area(const RegionView& regions, const CallOptions& options = {});

/// The smallest rectangle with all points; nothing where there are none. Exact. Cost: linear.
/// Throws Error: as `area`.
OBLAST_API std::optional<Box> bounds(const RegionView& regions, const CallOptions& options = {});

}  // namespace oblast
