// A region set of its own, of what a caller's arrays show.
#pragma once

#include <oblast/region_set.h>

namespace oblast::internal {

/// Offsets count from zero in the copy. REQUIRES: validated.
inline RegionSet copy_of(const RegionView& regions) {
  RegionSet copy{{regions.points.begin(), regions.points.end()},
                 {regions.contour_ends.begin(), regions.contour_ends.end()},
                 {regions.polygon_ends.begin(), regions.polygon_ends.end()}};
  for (std::uint32_t& end : copy.contour_ends) end -= regions.first_point;
  for (std::uint32_t& end : copy.polygon_ends) end -= regions.first_contour;
  return copy;
}

}  // namespace oblast::internal
