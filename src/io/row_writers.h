// The writers of rows, by kind of format; write_rows.h chooses.
#pragma once

#include <oblast/features.h>

#include <functional>
#include <string>
#include <vector>

#include "io/gdal_output_file.h"
#include "io/geopackage_geometry.h"
#include "io/row_columns.h"

namespace oblast::io {

struct RowOutput {
  const FeatureView& rows;
  std::span<const OutputColumn> columns;
  const std::string& crs_wkt;
  const std::string& name;  ///< of the file, for messages
  std::function<void(double share)> progress = {};
};

/// With GDAL's driver; a GeoPackage gets `shape`. Then reads the file back, and throws IoError if something is missing.
void write_rows_with_gdal(const GdalLayer& what, const RowOutput& output, GeopackageShape shape,
                          std::vector<std::string>& notes);

std::string rows_to_geojson(const RowOutput& output, std::vector<std::string>& notes);

/// A table with the column WKT first, and the types of its columns for a .csvt file beside it.
struct CsvText {
  std::string table, types;
};
CsvText rows_to_csv(const RowOutput& output, std::vector<std::string>& notes);

/// One line of WKT a row.
std::string rows_to_wkt(const FeatureView& rows);
/// The WKB of each row, one after the other.
std::string rows_to_wkb(const FeatureView& rows);

/// The polygons of one row, as a region set of their own.
RegionSet regions_of(const FeatureView& rows, std::size_t row);

}  // namespace oblast::io
