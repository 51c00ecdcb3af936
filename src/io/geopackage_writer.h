// Rows into a GeoPackage by SQLite itself. GDAL makes the file and the empty layer; its driver would then take several
// times as long for each row, and on one core. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <ogrsf_frmts.h>

#include <functional>
#include <string>
#include <vector>

#include "io/gdal_output_file.h"
#include "io/geopackage_geometry.h"
#include "io/row_fields.h"

namespace oblast::io {

struct GeopackageRows {
  const GdalLayer& what;
  const FeatureView& rows;
  const RowFields& fields;
  OGRFeatureDefn& definition;  ///< with the fields of the plan
  GeopackageShape shape;
  std::string id_column, geometry_column;
  const std::function<void(double share)>& progress;  ///< of what has been written and read back; may be empty
};

/// Whether this writer knows the types of all columns.
bool can_write_rows(const FieldPlan& plan);

/// Fills the empty layer that GDAL has made and closed, with its spatial index and its counts. Throws IoError.
void write_rows(const GeopackageRows& output);

/// Reads the layer back. Returns by column how many values differ from what was given: those that SQLite does not know,
/// which is NaN. Throws IoError if anything else differs, or is missing.
std::vector<std::uint64_t> check_rows(const GeopackageRows& output);

}  // namespace oblast::io
