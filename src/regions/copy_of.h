// Copies a view into a region set.
#pragma once

#include <oblast/region_set.h>

namespace oblast::internal {

/// The copy. Its offsets begin at zero. REQUIRES: the view is valid.
inline RegionSet copy_of(const RegionView& regions) {
  RegionSet copy{{regions.points.begin(), regions.points.end()},
                 {regions.contour_ends.begin(), regions.contour_ends.end()},
                 {regions.polygon_ends.begin(), regions.polygon_ends.end()}};
  for (std::uint32_t& end : copy.contour_ends) end -= regions.first_point;
  for (std::uint32_t& end : copy.polygon_ends) end -= regions.first_contour;
  return copy;
}

}  // namespace oblast::internal
