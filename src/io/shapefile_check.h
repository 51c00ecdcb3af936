// Finds faults of a broken shapefile that GDAL does not report.
#pragma once

#include <string>

namespace oblast::io {

/// Compares the sizes that `path` (.shp) and the .shx and .dbf beside it declare with the sizes of the files and with
/// each other. Throws IoError for a truncated file, a missing .shx, a .dbf with a different number of records, and a
/// shape type other than polygons of the plane. The .dbf may be missing.
void check_shapefile(const std::string& path);

/// The file beside `path` with the given extension, in upper or lower case; empty if there is none.
std::string find_sibling(const std::string& path, const std::string& extension);

}  // namespace oblast::io
