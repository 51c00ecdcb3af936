// SVG drawn as PNG, by librsvg and cairo. A build without them says so.
#pragma once

#include <string>

namespace oblast::io {

/// False if the program was built without librsvg.
bool can_draw_png();

/// Draws an SVG with `scale` pixels a unit, and returns the bytes of the PNG. Throws IoError.
std::string to_png(const std::string& svg, double scale);

}  // namespace oblast::io
