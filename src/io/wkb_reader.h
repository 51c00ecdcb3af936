// Reads Well-Known Binary.
#pragma once

#include <string>

#include "io/layer.h"
#include "io/read.h"

namespace oblast::io {

/// Any number of geometries, one after the other: bytes, or hexadecimal digits with white space between geometries.
/// WKB of the OGC, of ISO, and EWKB, whose SRID names the coordinate system. Messages call the data `name`. Throws
/// IoError with the number of the geometry and the byte.
Layer read_wkb(const std::string& bytes, const std::string& name, const ReadOptions& options = {});

}  // namespace oblast::io
