#include "oblast/zones_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oblast/buffer_plane.h"
#include "oblast/command.h"

namespace oblast::app {

namespace {

constexpr double percent = 0.01;

Tolerance tolerance_of(const std::string& word) {
  constexpr double least = 1e-12, most = 0.1;
  const std::optional<Length> given = parse_length(word);
  if (!given)
    throw CallError(fmt::format(
        "--tolerance '{}': write a length such as 0.1m, or a share of the extent such as 1e-6 or 0.001%", word));
  Tolerance tolerance{*given};
  if (given->unit == "%") tolerance.length = {given->number * percent, ""};
  const double number = tolerance.length.number;
  if (!(number > 0)) throw CallError(fmt::format("--tolerance {}: it must be above 0", word));
  if (!tolerance.is_absolute() && !(number >= least && number <= most))
    throw CallError(fmt::format(
        "--tolerance {}: a share of the extent must be from 1e-12 to 0.1 (10%); for a length add its unit, such as "
        "0.1m, or `units` for that of the coordinates",
        word));
  return tolerance;
}

Length distance_of(const std::string& word) {
  const std::optional<Length> given = parse_length(word);
  if (!given || given->unit == "%")
    throw CallError(fmt::format("--distance '{}': write a number with a unit, such as 500m, or without one", word));
  if (!(given->number > 0)) throw CallError(fmt::format("--distance {}: it must be above 0", word));
  return *given;
}

void extend(Box& box, const Box& other) {
  box = {std::min(box.x0, other.x0), std::min(box.y0, other.y0), std::max(box.x1, other.x1),
         std::max(box.y1, other.y1)};
}

}  // namespace

ZonePlan zone_plan(const std::string& tolerance, const std::string& distance, const std::string& crs) {
  ZonePlan plan;
  if (!tolerance.empty()) plan.tolerance = tolerance_of(tolerance);
  if (!distance.empty()) plan.distance = distance_of(distance);
  plan.crs = parse_plane(crs);
  return plan;
}

PlaneChoice choose_plane(const ZonePlan& plan, const io::Layer& objects, const io::Layer* frame) {
  PlaneQuery query{plan.crs, {}, 0, false, "the nearest object needs", "--tolerance \"1e-6 degrees\""};
  query.in_degrees =
      (plan.tolerance && is_degrees(plan.tolerance->length)) || (plan.distance && is_degrees(*plan.distance));
  query.extent = extent_of(objects).value_or(Box{0, 0, 0, 0});  // of an empty layer any will do
  if (plan.crs == "auto" && !query.in_degrees) {
    const Box& box = query.extent;
    // The box that zones fill if nothing else is said has a margin of a tenth.
    constexpr double metres_of_degree = 111'320, margin = 0.1;
    query.reach = margin * metres_of_degree * std::max(box.x1 - box.x0, box.y1 - box.y0);
    if (plan.distance) query.reach = in_units(*plan.distance, {false, 1, 0});
    if (frame)
      if (const std::optional<Box> of_frame = extent_of(*frame)) extend(query.extent, *of_frame);
  }
  return choose_plane(objects, query);
}

void set_lengths(ZoneOptions& options, const ZonePlan& plan, const io::CoordinateUnit& unit) {
  if (plan.tolerance && plan.tolerance->is_absolute())
    options.tolerance = in_units(plan.tolerance->length, unit);
  else if (plan.tolerance)
    options.relative_tolerance = plan.tolerance->length.number;
  if (plan.distance) options.distance = in_units(*plan.distance, unit);
}

}  // namespace oblast::app
