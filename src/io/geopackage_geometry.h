// Polygons as a GeoPackage stores them.
#pragma once

#include <oblast/features.h>
#include <oblast/measure.h>

#include <cstdint>
#include <vector>

namespace oblast::io {

/// Which geometries a layer of a GeoPackage has.
enum class GeopackageShape { polygon, multipolygon };

/// Replaces `blob` by the polygons of a row: the header of GeoPackage with the box, and WKB, little-endian. `box`
/// becomes their box. REQUIRES: the row has polygons, with points; exactly one for GeopackageShape::polygon.
void geopackage_blob(const FeatureView& rows, std::size_t row, GeopackageShape shape, std::int32_t srs_id,
                     std::vector<unsigned char>& blob, Box& box);

}  // namespace oblast::io
