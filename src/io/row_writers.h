// The writers of rows, by kind of format; write_rows.h chooses.
#pragma once

#include <oblast/features.h>

#include <string>
#include <vector>

#include "io/row_columns.h"

namespace oblast::io {

struct RowOutput {
  const FeatureView& rows;
  std::span<const OutputColumn> columns;
  const std::string& crs_wkt;
  const std::string& name;  ///< of the file, for messages
};

/// With GDAL's driver. Then reads the file back, and throws IoError if something is missing.
void write_rows_with_gdal(const std::string& path, const char* driver, const RowOutput& output,
                          std::vector<std::string>& notes);

std::string rows_to_geojson(const RowOutput& output, std::vector<std::string>& notes);

/// One line of WKT a row.
std::string rows_to_wkt(const FeatureView& rows);

}  // namespace oblast::io
