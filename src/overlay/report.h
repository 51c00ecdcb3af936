// What a call reports of its input and its result.
#pragma once

#include <oblast/options.h>
#include <oblast/region_set.h>

#include <algorithm>
#include <span>

#include "plane/largest_ulp.h"

namespace oblast::internal {

/// Fills in the counts, and the largest displacement in units of the largest coordinate. The pipeline fills the rest.
inline void report(std::span<const RegionView> operands, const RegionSet& result, Statistics& statistics) {
  for (const RegionView& operand : operands) {
    statistics.input_contours += operand.contour_count();
    statistics.input_vertices += operand.points.size();
  }
  statistics.output_polygons = result.polygon_ends.size();
  statistics.output_contours = result.contour_ends.size();
  statistics.output_vertices = result.points.size();
  if (statistics.largest_displacement == 0) return;
  double largest = 0;
  for (const RegionView& operand : operands) largest = std::max(largest, largest_coordinate(operand.points));
  statistics.largest_displacement_ulps = statistics.largest_displacement / ulp_of(largest);
}

}  // namespace oblast::internal
