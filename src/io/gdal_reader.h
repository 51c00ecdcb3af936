// Reading one layer of one file with GDAL.
#pragma once

#include <string>

#include "io/layer.h"
#include "io/read.h"
#include "io/read_parts.h"
#include "io/source.h"

namespace oblast::io {

/// A file, and how messages call it.
struct NamedSource {
  Source source;
  std::string name;
};

/// Every polygon of one layer; with Attributes::keep also the rows of `table`. Several threads may call it. Throws
/// IoError.
Layer read_with_gdal(const NamedSource& named, const ReadOptions& options, Attributes attributes, FileTable& table);

}  // namespace oblast::io
