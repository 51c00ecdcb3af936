// What GDAL lets pass in a broken shapefile and a person would want to know.
#pragma once

#include <string>

namespace oblast::io {

/// Compares the sizes that `path` (.shp) and the .shx and .dbf beside it declare with the files' own
/// sizes and with each other. Throws IoError for a truncated file, a missing .shx, a .dbf with another
/// number of records, and for shape types that are no polygons of the plane. A .dbf may be missing.
void check_shapefile(const std::string& path);

/// The file beside `path` with another extension, upper or lower case; empty when there is none.
std::string find_sibling(const std::string& path, const std::string& extension);

}  // namespace oblast::io
