// The attributes of blocks of GeoJSON as GDAL's features. Only for use inside src/io, because it has GDAL types.
#pragma once

#include <ogrsf_frmts.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "io/geojson_block.h"

namespace oblast::io {

/// Makes a row for each feature of a block, with the number `ids[feature]`. False if a value does not fit the type of
/// its column in a way that is plain; then GDAL must convert it.
bool make_rows(const GeojsonBlock& block, OGRFeatureDefn& definition, std::span<const std::int64_t> ids,
               std::span<std::unique_ptr<OGRFeature>> rows);

}  // namespace oblast::io
