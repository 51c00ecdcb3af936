#include "oblast/buffer_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/crs.h"
#include "oblast/buffer_plane.h"
#include "oblast/command.h"

namespace oblast::app {

namespace {

[[noreturn]] void refuse_degrees(const io::Layer& layer) {
  throw CallError(fmt::format(
      "the coordinates are longitudes and latitudes ({}), so a distance needs a projected system: a degree is 111 km "
      "from south to north, but from west to east 111 km at the equator, 56 km at 60 degrees of latitude and nothing "
      "at a pole. Add `--crs auto` to compute in a system that fits the layer and come back, `--crs EPSG:N` to choose "
      "that system, or `--t_srs EPSG:N` to stay in it. If degrees are meant, write --distance \"0.1 degrees\"",
      io::crs_name(layer.crs_wkt)));
}

// The largest distance in metres, for a system with that unit.
double reach_of(const BufferPlan& plan, const io::Rows& rows) {
  double reach = 0;
  for (const double distance : distances(plan.distance, rows, {false, 1, 0}))
    reach = std::max(reach, std::abs(distance));
  return reach;
}

}  // namespace

BufferPlan buffer_plan(const std::string& distance, const std::string& tolerance, const std::string& crs) {
  BufferPlan plan{parse_distance(distance), parse_tolerance(tolerance), crs};
  if (plan.crs.empty() || plan.crs == "auto") return plan;
  try {
    plan.crs = io::crs_from_text(crs);
  } catch (const io::IoError& error) {
    throw CallError(std::string("--crs: ") + error.what() + "; or `auto`");
  }
  if (io::coordinate_unit(plan.crs).angle)
    throw CallError(
        fmt::format("--crs {}: {} has degrees, in which no distance can be measured; name a projected "
                    "system, or `auto`",
                    crs, io::crs_name(plan.crs)));
  return plan;
}

PlaneChoice choose_plane(const BufferPlan& plan, const io::Rows& rows) {
  const io::Layer& layer = rows.layer;
  const io::CoordinateUnit unit = io::coordinate_unit(layer.crs_wkt);
  const bool in_degrees = plan.distance.length && is_degrees(*plan.distance.length);
  if (plan.crs.empty()) {
    if (unit.angle && !in_degrees) refuse_degrees(layer);
    return {};
  }
  if (in_degrees) throw CallError("--crs is for distances in units of length; leave it out, or write --distance 500m");
  if (layer.crs_wkt.empty())
    throw CallError("--crs: the files name no coordinate system; say with --assume-crs in which one they are");
  if (plan.crs != "auto") return {io::same_crs(plan.crs, layer.crs_wkt) ? "" : plan.crs, ""};
  if (!unit.angle)
    return {"", fmt::format("--crs auto: {} is projected already; computed in it", io::crs_name(layer.crs_wkt))};
  const Box extent = extent_of(layer).value_or(Box{0, 0, 0, 0});  // of an empty layer any will do
  const io::WorkingCrs working = io::suitable_crs(layer.crs_wkt, extent, reach_of(plan, rows));
  constexpr double large = 0.02, percent = 100;
  return {working.wkt, fmt::format("{}computed in {}, where lengths are true to about {:.2g} %",
                                   working.scale_error > large ? "warning: " : "", io::crs_name(working.wkt),
                                   percent * working.scale_error)};
}

}  // namespace oblast::app
