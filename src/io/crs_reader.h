// The coordinate system of an open layer; for use inside src/io, as it speaks GDAL.
#pragma once

#include <string>

class OGRLayer;

namespace oblast::io {

/// As WKT (2019); empty where the layer has none. `path` is the layer's file. Throws IoError for a
/// .prj that cannot be understood. May be called from several threads.
std::string read_crs(OGRLayer& layer, const std::string& path);

}  // namespace oblast::io
