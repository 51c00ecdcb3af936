// Finds a fault of a GeoPackage that SQLite reports only if it happens to need the missing part.
#pragma once

#include <string>

namespace oblast::io {

/// Throws IoError if the file is shorter than its header says. Files with a write-ahead log beside them are not judged.
void check_geopackage(const std::string& path);

}  // namespace oblast::io
