// The data that is read from vector files: one operand as flat arrays, with the file and feature of each polygon.
#pragma once

#include <oblast/error.h>
#include <oblast/region_set.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace oblast::io {

/// An error in the data or with a file (exit code 1). The message names file, feature, part and vertex.
class IoError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An input that is not there or must not be read: the call is wrong, not the data (exit code 2).
class CannotOpen : public IoError {
  using IoError::IoError;
};

/// The polygons of one feature of one file.
struct FeatureRange {
  std::uint32_t first_polygon = 0;  ///< the polygons end where those of the next feature begin
  std::uint32_t file = 0;           ///< index into Layer::files
  std::int64_t feature = 0;         ///< the file's own feature id
};

/// Lines and points of a layer that was read with OtherGeometry::keep. A feature is an index into Layer::features;
/// those of the lines do not decrease, nor do those of the points.
struct LinesAndPoints {
  std::vector<Point> line_vertices;
  std::vector<std::uint32_t> line_ends;  ///< line l is [line_ends[l-1], line_ends[l])
  std::vector<std::uint32_t> line_features;
  std::vector<Point> points;
  std::vector<std::uint32_t> point_features;
};

/// Counts for notes to the user about what was read.
struct ReadReport {
  std::uint64_t features = 0;
  std::uint64_t null_geometries = 0;
  std::uint64_t empty_geometries = 0;
  std::uint64_t lines = 0;   ///< line geometries that were skipped
  std::uint64_t points = 0;  ///< point geometries that were skipped
  std::uint64_t with_z = 0;  ///< features whose Z was ignored
  std::uint64_t with_m = 0;  ///< features whose M was ignored
  std::uint64_t unclosed_contours = 0;
  std::uint64_t repeated_vertices = 0;
  std::uint64_t beyond_pole = 0;       ///< vertices with a latitude beyond 90 degrees
  std::uint64_t across_date_line = 0;  ///< polygons and lines that seem to cross 180 degrees of longitude
  std::uint64_t swapped = 0;           ///< files whose longitudes and latitudes seem to be swapped
};

/// One operand. Rings keep the direction that they have in the files, except that the rings of shapefiles are reversed,
/// because their outer rings run clockwise. Closing points and repeated neighbours are removed.
struct Layer {
  RegionSet regions;
  LinesAndPoints others;  ///< empty unless they are kept
  std::vector<FeatureRange> features;
  std::vector<std::string> files;
  std::string crs_wkt;  ///< coordinate system as WKT, without heights; empty if the files name none
  ReadReport report;
  std::vector<std::uint32_t> open_contours;  ///< those that the file does not close; only with RingVertices::all
  std::vector<std::string> columns;          ///< names of the attributes of the features; they are not in the layer
  std::vector<std::string> notes;  ///< what else the user should know of the reading: one line each, none twice
};

/// A place in the layer, for messages: "fires/0412.shp, feature 17, part 2, ring 1, vertex 5". Features have the ids of
/// the file; vertices count from 0, parts and rings from 1.
std::string describe(const Layer& layer, const Place& place);

}  // namespace oblast::io
