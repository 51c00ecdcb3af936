// Writes a region set completely or not at all: to a temporary name beside the target, which is then renamed.
#pragma once

#include <oblast/region_set.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "io/layer.h"
#include "io/output_target.h"

namespace oblast::io {

enum class Existing { refuse, overwrite };
/// Of standard output; the extension of a file decides its format.
enum class TextFormat { wkt, wkb, geojson };
/// Of a file that our own code writes as one text. REQUIRES: its extension is of such a format.
TextFormat text_format_of(const std::string& path);

struct WriteOptions {
  Existing existing = Existing::refuse;
  std::string crs_wkt;  ///< written into the file if its format can store one
  /// The attribute `polygon` of each feature, by polygon (WKT has none); empty: 0, 1, 2, ...
  std::span<const std::int32_t> polygon_numbers = {};
  TextFormat standard_output = TextFormat::wkt;
  /// Gets the share of a GeoPackage that has been written, again and again, from one thread at a time.
  std::function<void(double share)> progress = {};
  std::vector<std::string>* notes = nullptr;  ///< gets a line for each thing that the user should know of the file
};

/// Throws IoError if `path` cannot be written: unknown format, missing folder, existing file. Call it before the
/// computation, to report the error early.
void check_writable(const std::string& path, const WriteOptions& options = {});

/// Writes one feature per polygon. The extension decides the format; `-` is standard output. `FILE.gpkg:LAYER` adds a
/// layer to a GeoPackage; other layers of an existing GeoPackage are always kept. Coordinates keep their bits, except
/// in .kml and .gml; text formats have the fewest digits that read back to the same bits. The bytes depend on the
/// arguments only. Throws IoError; then an older file at `path` is unchanged.
void write(const std::string& path, const RegionView& regions, const WriteOptions& options = {});

/// Writes to a temporary name, and renames. `write_to` gets the temporary path. There is a file at that path if a layer
/// is to be added to it. Throws IoError.
void write_staged(const OutputTarget& target, const WriteOptions& options,
                  const std::function<void(const std::string& path)>& write_to);

/// Throws IoError if a format that knows one coordinate system only is to be written in another.
void check_crs_of_format(const std::string& path, const std::string& crs_wkt);

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
