// The authority's code of a coordinate system; for use inside src/io, as it speaks GDAL.
#pragma once

#include <string>

class OGRSpatialReference;

namespace oblast::io {

/// "EPSG:4326", also where the text carries no code but PROJ's database knows the system. Empty otherwise.
std::string crs_code(const OGRSpatialReference& crs);

}  // namespace oblast::io
