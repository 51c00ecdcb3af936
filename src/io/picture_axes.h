// Ticks, labels and a scale bar around a panel.
#pragma once

#include <string>

#include "io/picture.h"
#include "io/picture_frame.h"

namespace oblast::io {

/// Ticks at round coordinates along the bottom and left sides, with their numbers, in pixels.
std::string draw_axes(const Frame& frame);

/// A bar of a round length with its unit in the lower right corner. `unit` is that of the coordinates in the plane.
std::string draw_scale_bar(const Frame& frame, MapProjection projection, const std::string& unit);

}  // namespace oblast::io
