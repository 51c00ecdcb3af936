// What GDAL lets pass in a broken shapefile and a person would want to know.
#pragma once

#include <cstdint>
#include <string>

namespace oblast::io {

struct ShapefileHeader {
  std::uint64_t records = 0;  ///< by the index file
  std::int32_t shape_type = 0;
};

/// Compares the sizes in the headers of `path` (.shp) and of the .shx beside it with the files' own
/// sizes. Throws IoError for a truncated or missing file and for shape types that are no polygons of the plane.
ShapefileHeader check_shapefile(const std::string& path);

/// The file beside `path` with another extension, upper or lower case; empty when there is none.
std::string find_sibling(const std::string& path, const std::string& extension);

}  // namespace oblast::io
