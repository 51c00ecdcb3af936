// Region sets written in a line: "x y, x y, x y; hole ... | next polygon ...".
#pragma once

#include <oblast/region_set.h>

#include <string>

namespace oblast::verify {

/// Vertices are separated by commas, contours by semicolons, polygons by bars.
RegionSet regions_of(const std::string& text);

}  // namespace oblast::verify
