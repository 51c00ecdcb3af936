// From geometries of GDAL to polygons, lines and points of a layer. Only for use inside src/io, because it has GDAL
// types.
#pragma once

#include <ogr_geometry.h>

#include <vector>

#include "io/layer_builder.h"

namespace oblast::io {

/// Throws IoError for curves and surfaces. The recursion is shallow: GDAL's readers accept collections that are nested
/// a few dozen levels deep at most.
void add_geometry(const OGRGeometry& geometry, LayerBuilder& builder, std::vector<Point>& scratch);

/// A record of a shapefile: all its rings are one polygon (gdal_reader.cpp says why).
void add_record(const OGRGeometry& geometry, LayerBuilder& builder, std::vector<Point>& scratch);

}  // namespace oblast::io
