// Reading one layer of one file with GDAL.
#pragma once

#include <functional>
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
  /// Gets the share of the file that has been read; several threads may call it. May be empty.
  std::function<void(double share)> progress = {};
};

/// The names of the attributes, but for the number that oblast gives polygons itself.
void name_columns(Layer& layer, const std::vector<Column>& columns);

/// Every polygon of one layer; with Attributes::keep also the rows of `table`. Several threads may call it. Throws
/// IoError.
Layer read_with_gdal(const NamedSource& named, const ReadOptions& options, Attributes attributes, FileTable& table);

}  // namespace oblast::io
