// What `oblast zones` is told, read before any file, and the system in which it computes.
#pragma once

#include <oblast/zones.h>

#include <optional>
#include <string>

#include "io/rows.h"
#include "oblast/buffer_distance.h"
#include "oblast/plane_choice.h"

namespace oblast::app {

struct ZonePlan {
  std::optional<Tolerance> tolerance;  ///< a share of the extent, or a length; none: what is usual
  std::optional<Length> distance;
  std::string crs;  ///< from parse_plane
};

/// From words, which may be empty. Throws CallError.
ZonePlan zone_plan(const std::string& tolerance, const std::string& distance, const std::string& crs);

/// The system to compute in. `frame` may be null. Throws as choose_plane(layer, query).
PlaneChoice choose_plane(const ZonePlan& plan, const io::Layer& objects, const io::Layer* frame);

/// Sets tolerance and distance in units of the system of the computation. Throws CallError as in_units.
void set_lengths(ZoneOptions& options, const ZonePlan& plan, const io::CoordinateUnit& unit);

}  // namespace oblast::app
