// Appends regions to regions.
#pragma once

#include <oblast/region_set.h>

#include "base/index.h"

namespace oblast::internal::repairing {

/// Throws Error(too_large).
inline void append_regions(const RegionView& part, RegionSet& all) {
  const std::uint32_t points = checked_index(all.points.size() + part.points.size(), "vertices of pieces") -
                               static_cast<std::uint32_t>(part.points.size());
  const auto contours = static_cast<std::uint32_t>(all.contour_ends.size());
  all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  for (std::size_t c = 0; c < part.contour_count(); ++c) all.contour_ends.push_back(points + part.contour_end(c));
  for (std::size_t p = 0; p < part.polygon_count(); ++p) all.polygon_ends.push_back(contours + part.polygon_end(p));
}

}  // namespace oblast::internal::repairing
