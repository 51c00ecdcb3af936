// What is read from vector files: one operand as flat arrays, with the way back to where it came from.
#pragma once

#include <oblast/error.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace oblast::io {

/// The data or a file is at fault (exit code 1). The message names file, feature, part and vertex.
class IoError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A run of polygons that came from one feature of one file.
struct FeatureRange {
  std::uint32_t first_polygon = 0;  ///< the run ends where the next one begins
  std::uint32_t file = 0;           ///< index into Layer::files
  std::int64_t feature = 0;         ///< the file's own feature id
};

/// Things worth saying once about what was read.
struct ReadReport {
  std::uint64_t features = 0;
  std::uint64_t null_geometries = 0;
  std::uint64_t empty_geometries = 0;
  std::uint64_t lines = 0;   ///< line features, passed over
  std::uint64_t points = 0;  ///< point features, passed over
  std::uint64_t with_z = 0;  ///< features whose Z was dropped
  std::uint64_t with_m = 0;  ///< features whose M was dropped
  std::uint64_t unclosed_contours = 0;
  std::uint64_t repeated_vertices = 0;
};

/// One operand. Rings are as in the files: any direction, closing point and repeated neighbours
/// removed. Only a shapefile's rings are turned round, since its outer rings run clockwise.
struct Layer {
  RegionSet regions;
  std::vector<FeatureRange> features;
  std::vector<std::string> files;
  std::string crs_wkt;  ///< coordinate system as WKT; empty where the files name none
  ReadReport report;
};

/// A human-readable place in the layer: "fires/0412.shp, feature 17, part 2, ring 1, vertex 5".
/// Features and vertices count from 0 as the file's own ids do; parts and rings from 1.
std::string describe(const Layer& layer, const Place& place);

}  // namespace oblast::io
