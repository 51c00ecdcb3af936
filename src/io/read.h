// Reads polygons, and lines and points if they are wanted, from any vector file that GDAL opens, from WKT and WKB, from
// folders and from standard input.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "io/layer.h"

namespace oblast::io {

/// What to do with lines and points.
enum class OtherGeometry {
  count_and_skip,
  refuse,
  keep,  ///< they go into Layer::others. REQUIRES: FeatureEntries::all
};

/// Which features get an entry in Layer::features.
enum class FeatureEntries {
  with_polygons,  ///< those that have polygons
  all,            ///< every one, also without geometry, in the order of the file: the rows of a table
};

/// What becomes of the vertices of rings.
enum class RingVertices {
  cleaned,  ///< repeated vertices are removed
  all,  ///< every vertex but the closing one stays, for checks; vertices have the numbers that they have in the file
};

struct ReadOptions {
  OtherGeometry other = OtherGeometry::count_and_skip;
  FeatureEntries entries = FeatureEntries::with_polygons;
  RingVertices vertices = RingVertices::cleaned;
  /// Only features for which this condition on their attributes holds, as in GDAL's `-where`: "area > 3". Empty: all.
  std::string where = {};
  std::string layer = {};       ///< the layer of each file for which none is named (FILE:LAYER)
  std::string output = {};      ///< the file that the call will write: passed over in folders; empty: none
  std::string assume_crs = {};  ///< WKT: the coordinate system of files that name none; empty: none
  std::string target_crs = {};  ///< WKT: all coordinates are transformed to this system; empty: they stay as they are
  int threads = 0;  ///< 0: all cores. Files are read in parallel; the order of the polygons does not depend on it
  /// Gets the share of the input that has been read, again and again; one thread at a time, and never a smaller share.
  std::function<void(double share)> progress = {};
  /// What GDAL's driver would make of a GeoJSON file is also made by a reader for all cores, and several times faster,
  /// where it understands the file. False: GDAL's driver reads all.
  bool fast_geojson = true;
};

/// Reads every polygon of every path as one operand. A path is as list_sources() in io/source.h takes it; `-` is WKT,
/// WKB or GeoJSON on standard input. Throws IoError, also for a file with several layers of which none is named.
Layer read(std::span<const std::string> paths, const ReadOptions& options = {});

/// Reads WKT: any number of POLYGON, MULTIPOLYGON and GEOMETRYCOLLECTION of these, usually one per line. "SRID=4326;"
/// before a geometry names its coordinate system, the same for all. Messages call the text `name`. Throws IoError with
/// the line and the column.
Layer read_wkt(const std::string& text, const std::string& name, const ReadOptions& options = {});

}  // namespace oblast::io
