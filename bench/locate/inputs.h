// Regions to be asked about, the points, and the true answers.
#pragma once

#include <oblast/locator.h>
#include <oblast/region_set.h>

#include <string>
#include <vector>

namespace oblast::bench {

/// A workload file's operand A, united; or circle:VERTICES, star:VERTICES (wiggly), snowflake:LEVEL.
RegionSet regions_named(const std::string& name);

/// All over the bounds.
std::vector<Point> points_all_over(const RegionView& regions, std::size_t count);
/// Half of them all over; a quarter up to 4 units in the last place from a vertex, in x and in y; a quarter up to an
/// edge's length from its beginning.
std::vector<Point> points_half_near_vertices(const RegionView& regions, std::size_t count);

/// Exactly, by all edges of a strip and the predicate of verify/: nothing of what is measured.
std::vector<Location> true_locations(const RegionView& regions, const std::vector<Point>& points);

}  // namespace oblast::bench
