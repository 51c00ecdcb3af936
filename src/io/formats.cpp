// The list of formats; see formats.h.
#include "io/formats.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

namespace {

constexpr Format known[] = {
    {".shp", {"ESRI Shapefile"}, "ESRI Shapefile", true, false},
    {".gpkg", {"GPKG"}, "GPKG", true, false},
    {".geojson", {"GeoJSON", "TopoJSON", "GeoJSONSeq", "ESRIJSON"}, nullptr, true, false},
    {".fgb", {"FlatGeobuf"}, "FlatGeobuf", true, false},
    {".wkt", {}, nullptr, true, false},
    {".json", {"GeoJSON", "TopoJSON", "ESRIJSON", "GeoJSONSeq"}, nullptr, true, true},
    {".topojson", {"TopoJSON", "GeoJSON"}, nullptr, false, false},
    {".geojsonl", {"GeoJSONSeq", "GeoJSON"}, nullptr, false, false},
    {".geojsons", {"GeoJSONSeq", "GeoJSON"}, nullptr, false, false},
    {".csv", {"CSV"}, nullptr, true, true},
    {".wkb", {}, nullptr, true, false},
    {".parquet", {"Parquet"}, "Parquet", true, false},
    {".kml", {"LIBKML", "KML"}, "LIBKML", true, false},
    {".gml", {"GML"}, "GML", true, false},
    {".tab", {"MapInfo File"}, nullptr, false, true},
    {".mif", {"MapInfo File"}, nullptr, false, false},
};

template <typename Keep>
std::string list(Keep keep) {
  std::string text;
  for (const Format& format : known) {
    if (!keep(format)) continue;
    if (!text.empty()) text += ' ';
    text += format.extension;
  }
  return text;
}

}  // namespace

std::span<const Format> formats() { return known; }

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

const Format* format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  const auto* found = std::find_if(std::begin(known), std::end(known),
                                   [&](const Format& format) { return format.extension == extension; });
  return found == std::end(known) ? nullptr : found;
}

bool is_wkt(const std::string& path) { return lower_extension(path) == ".wkt"; }
bool is_wkb(const std::string& path) { return lower_extension(path) == ".wkb"; }
bool is_csv(const std::string& path) { return lower_extension(path) == ".csv"; }

bool is_geojson(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".geojson" || extension == ".json";
}

void require_driver(const Format& format, const std::string& path) {
  if (!format.drivers[0]) return;
  register_gdal_drivers();
  for (const char* driver : format.drivers) {
    if (driver && GetGDALDriverManager()->GetDriverByName(driver)) return;
  }
  throw IoError(fmt::format("{} cannot be read: this build of GDAL has no driver {}; convert it to .gpkg first", path,
                            format.drivers[0]));
}

void require_writer(const Format& format, const std::string& path) {
  if (!format.writer) return;
  register_gdal_drivers();
  if (GetGDALDriverManager()->GetDriverByName(format.writer)) return;
  throw IoError(fmt::format("cannot write {}: this build of GDAL has no driver {}; write .gpkg or .fgb instead", path,
                            format.writer));
}

std::string readable_extensions() {
  return list([](const Format&) { return true; });
}

std::string writable_extensions() {
  return list([](const Format& format) { return format.writable; });
}

}  // namespace oblast::io
