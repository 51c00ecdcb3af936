#include "oblast/buffer_plan.h"

#include <algorithm>
#include <cmath>

#include "oblast/buffer_plane.h"

namespace oblast::app {

namespace {

// The largest distance in metres, for a system with that unit.
double reach_of(const BufferPlan& plan, const io::Rows& rows) {
  double reach = 0;
  for (const double distance : distances(plan.distance, rows, {false, 1, 0}))
    reach = std::max(reach, std::abs(distance));
  return reach;
}

}  // namespace

BufferPlan buffer_plan(const std::string& distance, const std::string& tolerance, const std::string& crs) {
  return {parse_distance(distance), parse_tolerance(tolerance), parse_plane(crs)};
}

PlaneChoice choose_plane(const BufferPlan& plan, const io::Rows& rows) {
  PlaneQuery query{plan.crs, {}, 0, false, "a distance needs", "--distance \"0.1 degrees\""};
  query.in_degrees = plan.distance.length && is_degrees(*plan.distance.length);
  query.extent = extent_of(rows.layer).value_or(Box{0, 0, 0, 0});  // of an empty layer any will do
  if (plan.crs == "auto" && !query.in_degrees) query.reach = reach_of(plan, rows);
  return choose_plane(rows.layer, query);
}

}  // namespace oblast::app
