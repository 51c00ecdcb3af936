// The vector formats, recognised by their file name extension.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace oblast::io {

struct Format {
  std::string_view extension;  ///< lower case, with its dot
  /// GDAL's drivers that can open the format, with nullptr at the end, so that GDAL does not try all others. None for
  /// WKT, which GDAL does not read here.
  const char* drivers[5];
  const char* writer;  ///< GDAL's driver that writes it, or nullptr: our own code does, or nothing
  bool writable;       ///< by GDAL or by our own code
  bool may_be_other;   ///< files with this extension may also be something else than vector data
};

std::span<const Format> formats();

/// nullptr if the extension is not in the list.
const Format* format_of(const std::string& path);

/// Throws IoError, which names `path`, if this GDAL has none of the drivers that read the format.
void require_driver(const Format& format, const std::string& path);

/// The same for writing.
void require_writer(const Format& format, const std::string& path);

/// ".shp .gpkg .geojson": for messages.
std::string readable_extensions();
std::string writable_extensions();

bool is_wkt(const std::string& path);
bool is_wkb(const std::string& path);
bool is_csv(const std::string& path);
bool is_geojson(const std::string& path);

/// The extension in lower case, with its dot.
std::string lower_extension(const std::string& path);

}  // namespace oblast::io
