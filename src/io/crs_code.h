// What src/io does with coordinate systems. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <string>

class OGRSpatialReference;

namespace oblast::io {

/// A code such as "EPSG:4326". If the text has none, PROJ's database is searched for the system. Empty if there is no
/// code.
std::string crs_code(const OGRSpatialReference& crs);

/// The system as WKT (2019), without its height axis; empty if GDAL cannot say it.
std::string horizontal_wkt(const OGRSpatialReference& crs);

/// x is longitude or easting from now on. False if the text is not understood.
bool import_crs(OGRSpatialReference& crs, const std::string& wkt);

}  // namespace oblast::io
