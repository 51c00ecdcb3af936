// What GDAL makes of the head of a GeoJSON file and of some of its features. Only for use inside src/io, because it has
// GDAL types.
#pragma once

#include <ogrsf_frmts.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/attribute_table.h"
#include "io/gdal_reader.h"

namespace oblast::io {

struct DefinitionRelease {
  void operator()(OGRFeatureDefn* definition) const { definition->Release(); }
};

struct GeojsonSchema {
  std::string crs_wkt;
  std::vector<std::string> notes;
  std::vector<Column> columns;
  std::string id_column;  ///< the column whose values are the numbers of the features; empty: none
  std::unique_ptr<OGRFeatureDefn, DefinitionRelease> definition;
};

/// `samples` are features as JSON. Nothing if GDAL cannot open a file of this head, or not as GeoJSON.
std::optional<GeojsonSchema> geojson_schema(const std::string& head, std::span<const std::string> samples,
                                            const NamedSource& named);

}  // namespace oblast::io
