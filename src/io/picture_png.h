// SVG drawn as PNG, by librsvg and cairo, which are loaded when the first one is drawn.
#pragma once

#include <string>

namespace oblast::io {

/// False if the program was built without librsvg, or if that is not installed. Loads it.
bool can_draw_png();

/// Draws an SVG with `scale` pixels a unit, and returns the bytes of the PNG. Throws IoError.
std::string to_png(const std::string& svg, double scale);

}  // namespace oblast::io
