// The authority's code of a coordinate system. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <string>

class OGRSpatialReference;

namespace oblast::io {

/// A code such as "EPSG:4326". If the text has none, PROJ's database is searched for the system. Empty if there is no
/// code.
std::string crs_code(const OGRSpatialReference& crs);

}  // namespace oblast::io
