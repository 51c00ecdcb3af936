// Shapes from WKT, with lines and points, for tests.
#pragma once

#include <string>

#include "buffer/buffer_trial.h"

namespace oblast::testing {

/// Points, lines and polygons, also of collections. Throws std::runtime_error for other text.
OwnedShapes shapes_from_wkt(const std::string& text);

}  // namespace oblast::testing
