// The coordinate system of an open layer. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <string>

class OGRLayer;

namespace oblast::io {

/// The coordinate system as WKT (2019); empty if the layer has none. `path` is the file of the layer. Throws IoError if
/// GDAL does not understand the .prj file. Several threads may call it.
std::string read_crs(OGRLayer& layer, const std::string& path);

}  // namespace oblast::io
