// Writes rows with attributes completely or not at all, as write.h does for region sets.
#pragma once

#include <oblast/features.h>

#include <span>
#include <string>
#include <vector>

#include "io/row_columns.h"
#include "io/write.h"

namespace oblast::io {

/// Writes one feature per row, in the order of the rows (FlatGeobuf's index sorts them by place). Formats that need one
/// type of geometry get MULTIPOLYGON. A row without polygons has no geometry; FlatGeobuf refuses it. Coordinates keep
/// their bits, and so do the values of attributes where the format can hold them. For every change that the format
/// needs, `notes` gets a line. WKT has one line a row, and WKB one geometry; both are without the attributes. Paths are
/// those of write(). REQUIRES: every column has an entry for each row. Throws IoError; then an older file at `path` is
/// unchanged.
void write_rows(const std::string& path, const FeatureView& rows, std::span<const OutputColumn> columns,
                const WriteOptions& options, std::vector<std::string>& notes);

}  // namespace oblast::io
