// Printing GeoJSON.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <string>

namespace oblast::io {

/// A FeatureCollection, one feature a line, coordinates with the shortest digits that read back to the
/// same bits. (GDAL's writer gives 17 digits where 4 would do, and its reader's speed pays for them.)
/// `crs_code` is the code of the coordinate system ("EPSG:3035"), or empty where there is none.
/// The property `polygon` is from `numbers`, or where that is empty the polygon's place.
std::string to_geojson(const RegionView& regions, const std::string& crs_code,
                       std::span<const std::int32_t> numbers = {});

/// How GeoJSON may name the coordinate system: "" for none. Throws IoError where a code is lacking:
/// GeoJSON has no other way to name one, and readers take a file without one for longitude and latitude.
std::string geojson_crs_code(const std::string& crs_wkt);

}  // namespace oblast::io
