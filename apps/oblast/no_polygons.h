// A file without polygons: there is nothing to check, which is said.
#pragma once

#include <optional>
#include <string>

#include "io/layer.h"

namespace oblast::app {

/// If the layer has no polygons, says so, with what it has instead, and returns the exit code: 1 if it has lines or
/// points, 0 if it is empty. Nothing if it has polygons.
std::optional<int> say_no_polygons(const std::string& file, const io::Layer& layer, bool json);

/// "12 lines and 3 points", which a check passes over; empty: there are none.
std::string lines_and_points(const io::ReadReport& report);

}  // namespace oblast::app
