// Reading polygons from any vector file GDAL opens, from WKT, from a folder or from standard input.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "io/layer.h"

namespace oblast::io {

/// What to do with lines and points in a polygon layer.
enum class OtherGeometry { count_and_skip, refuse };

struct ReadOptions {
  OtherGeometry other = OtherGeometry::count_and_skip;
  int threads = 0;  ///< 0: all cores; many files are read in parallel, in the order of their names
  std::function<void(std::size_t files_done, std::size_t files)> progress;
};

/// Reads every polygon of every path as one operand. A path is a vector file, a folder (all vector
/// files in it, by name), a `.wkt` file, or `-` for WKT on standard input. Throws IoError.
Layer read(std::span<const std::string> paths, const ReadOptions& options = {});

/// Parses WKT text: POLYGON, MULTIPOLYGON, GEOMETRYCOLLECTION of these; one geometry a line where there are
/// several. `name` stands for the file in messages. Throws IoError with the line and column.
Layer read_wkt(const std::string& text, const std::string& name, const ReadOptions& options = {});

}  // namespace oblast::io
