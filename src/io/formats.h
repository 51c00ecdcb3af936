// The vector formats known by their file name extension.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace oblast::io {

struct Format {
  std::string_view extension;  ///< lower case, with its dot
  /// GDAL's drivers that may open it, ended by nullptr: naming them spares probing all others.
  /// None for WKT, which is read here.
  const char* drivers[5];
  const char* writer;  ///< GDAL's driver that writes it, or nullptr
  bool writable;       ///< by GDAL or by ourselves
  bool may_be_other;   ///< the extension is also used for files that are no vector data
};

std::span<const Format> formats();

/// nullptr for an extension that is not in the list.
const Format* format_of(const std::string& path);

/// ".shp .gpkg .geojson": for messages.
std::string readable_extensions();
std::string writable_extensions();

/// The extension in lower case, with its dot.
std::string lower_extension(const std::string& path);

}  // namespace oblast::io
