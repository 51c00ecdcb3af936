// Writes a region set completely or not at all: to a temporary name beside the target, which is then renamed.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "io/layer.h"

namespace oblast::io {

enum class Existing { refuse, overwrite };

struct WriteOptions {
  Existing existing = Existing::refuse;
  std::string crs_wkt;  ///< written into the file if its format can store one
  /// The attribute `polygon` of each feature, by polygon (WKT has none); empty: 0, 1, 2, ...
  std::span<const std::int32_t> polygon_numbers = {};
};

/// Throws IoError if `path` cannot be written: unknown format, missing folder, existing file. Call it before the
/// computation, to report the error early.
void check_writable(const std::string& path, const WriteOptions& options = {});

/// Writes one feature per polygon. The extension decides the format (.shp .gpkg .geojson .fgb .wkt; `-` is WKT on
/// standard output). Coordinates keep their bits; text formats have the fewest digits that read back to the same bits.
/// Throws IoError; then an older file at `path` is unchanged.
void write(const std::string& path, const RegionView& regions, const WriteOptions& options = {});

/// The name under which a result is written: GDAL gives the files of a shapefile lower-case extensions.
std::string target_of(const std::string& path);

/// Writes to a temporary name, and renames. `write_to` gets the temporary path.
void write_staged(const std::string& target, Existing existing,
                  const std::function<void(const std::string& path)>& write_to);

/// Call this first when a signal is to end the program. True: no output replaces an older one any more. False: one does
/// so now or has done so, and the program must go on to its end or to expect_more_output(). Safe in a signal handler.
bool stop_outputs();
/// Removes the temporary files of the outputs that are being written. Safe in a signal handler.
void discard_unfinished();
/// Call this when an output is complete and another will follow: stop_outputs() may succeed again.
void expect_more_output();

/// One line of WKT: MULTIPOLYGON (or POLYGON EMPTY), shortest digits that read back to the same bits.
std::string to_wkt(const RegionView& regions);

}  // namespace oblast::io
