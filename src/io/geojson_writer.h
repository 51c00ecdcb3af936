// Printing GeoJSON.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <string>

namespace oblast::io {

/// A FeatureCollection with one feature per line. Coordinates have the fewest digits that read back to the same bits.
/// (GDAL's writer prints 17 digits even if 4 suffice, which makes reading slower.) `crs_code` is the code of the
/// coordinate system ("EPSG:3035"), or empty if there is none. The property `polygon` is the number from `numbers`, or
/// the position of the polygon if `numbers` is empty.
std::string to_geojson(const RegionView& regions, const std::string& crs_code,
                       std::span<const std::int32_t> numbers = {});

/// The coordinates of a polygon: an array of rings.
void append_geojson_polygon(std::string& text, const RegionView& regions, std::size_t p);
/// All that comes before the first feature.
std::string geojson_begin(const std::string& crs_code);

/// The code by which GeoJSON names the coordinate system; "" for none. Throws IoError if the system has no code:
/// GeoJSON cannot name it otherwise, and readers assume longitude and latitude for a file without a name.
std::string geojson_crs_code(const std::string& crs_wkt);

}  // namespace oblast::io
