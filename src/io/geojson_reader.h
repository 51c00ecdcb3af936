// Reads large GeoJSON files on all cores. GDAL's driver parses them on one, and several times slower.
//
// GDAL stays the judge of what a file means: it is given the head of the file, and the features that show what kinds of
// values the columns have. From these it makes the layer, its coordinate system and the types of the columns. What this
// reader does not know, from nested objects to geometries that are no polygons, and every error, is left to GDAL, which
// then reads the whole file.
#pragma once

#include <optional>

#include "io/gdal_reader.h"
#include "io/layer.h"
#include "io/read.h"
#include "io/read_parts.h"
#include "io/text_source.h"

namespace oblast::io {

/// The same as read_with_gdal() for this text, or nothing if GDAL must read it. `table` is changed only if there is a
/// result. Throws IoError if the file cannot be read.
std::optional<Layer> read_geojson(const TextSource& text, const NamedSource& named, const ReadOptions& options,
                                  Attributes attributes, FileTable& table);

}  // namespace oblast::io
