// Writing a region set, all or nothing: to a temporary name beside the target, then renamed.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <span>
#include <string>

#include "io/layer.h"

namespace oblast::io {

enum class Existing { refuse, overwrite };

struct WriteOptions {
  Existing existing = Existing::refuse;
  std::string crs_wkt;  ///< written into the file where its format holds one
  /// The attribute `polygon` of each feature, by polygon (WKT has none); empty: 0, 1, 2, ...
  std::span<const std::int32_t> polygon_numbers = {};
};

/// Throws IoError when `path` cannot be written: unknown format, missing folder, existing file.
/// Call it before the work, so that nobody waits for an overlay that cannot be saved.
void check_writable(const std::string& path, const WriteOptions& options = {});

/// Writes one feature a polygon; the format follows the extension (.shp .gpkg .geojson .fgb .wkt;
/// `-` is WKT on standard output). Coordinates keep their bits (text formats: 17 digits). Throws IoError, and
/// then an older file at `path` is untouched.
void write(const std::string& path, const RegionView& regions, const WriteOptions& options = {});

/// Removes temporary files of writes under way. Safe to call in a signal handler.
void discard_unfinished();
/// True while finished files take the places of older ones: to end the program now would leave some of each. Safe to
/// call in a signal handler.
bool commit_under_way();

/// One line of WKT: MULTIPOLYGON (or POLYGON EMPTY), shortest digits that read back to the same bits.
std::string to_wkt(const RegionView& regions);

}  // namespace oblast::io
