// Reading one file with GDAL.
#pragma once

#include <string>

#include "io/layer.h"
#include "io/read.h"

namespace oblast::io {

/// Every polygon of every layer of one file. Several threads may call it. Throws IoError.
Layer read_with_gdal(const std::string& path, const ReadOptions& options);

}  // namespace oblast::io
