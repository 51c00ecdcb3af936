// GeoJSON (RFC 7946). If a layer is not in longitude and latitude of WGS 84, the file has the `crs` member of the 2008
// specification, the predecessor of the RFC. Rings are not reversed, split or rounded.
#include "io/geojson_writer.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include "io/crs.h"
#include "io/crs_code.h"
#include "io/gdal_session.h"
#include "io/layer.h"
#include "io/number_text.h"

namespace oblast::io {

namespace {

void append_position(std::string& text, const Point& p) {
  text += '[';
  append_number(text, p.x);
  text += ',';
  append_number(text, p.y);
  text += ']';
}

void append_contour(std::string& text, std::span<const Point> contour) {
  text += '[';
  for (const Point& p : contour) {
    append_position(text, p);
    text += ',';
  }
  append_position(text, contour.front());
  text += ']';
}

// "EPSG:3035" as the OGC's uniform resource name.
std::string crs_member(const std::string& code) {
  const std::size_t colon = code.find(':');
  const std::string authority = code.substr(0, colon), number = code.substr(colon + 1);
  const std::string urn = authority == "OGC" || code == "EPSG:4326" ? "urn:ogc:def:crs:OGC:1.3:CRS84"
                                                                    : "urn:ogc:def:crs:" + authority + "::" + number;
  return fmt::format(R"("crs":{{"type":"name","properties":{{"name":"{}"}}}},)", urn) + "\n";
}

void append_feature(std::string& text, const RegionView& regions, std::size_t p, std::int64_t number) {
  text += fmt::format(
      R"({{"type":"Feature","properties":{{"polygon":{}}},"geometry":{{"type":"Polygon","coordinates":)", number);
  append_geojson_polygon(text, regions, p);
  text += "}}";
}

}  // namespace

void append_geojson_polygon(std::string& text, const RegionView& regions, std::size_t p) {
  text += '[';
  bool first = true;
  for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
    if (regions.contour(c).empty()) continue;
    if (!first) text += ',';
    append_contour(text, regions.contour(c));
    first = false;
  }
  text += ']';
}

std::string geojson_begin(const std::string& crs_code_text) {
  std::string text = "{\"type\":\"FeatureCollection\",\n";
  if (!crs_code_text.empty()) text += crs_member(crs_code_text);
  return text + "\"features\":[\n";
}

std::string to_geojson(const RegionView& regions, const std::string& crs_code_text,
                       std::span<const std::int32_t> numbers) {
  constexpr std::size_t typical_vertex_length = 40, typical_feature_length = 100;
  std::string text;
  text.reserve(regions.points.size() * typical_vertex_length + regions.polygon_count() * typical_feature_length + 200);
  text += geojson_begin(crs_code_text);
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    append_feature(text, regions, p, numbers.empty() ? static_cast<std::int64_t>(p) : numbers[p]);
    text += p + 1 < regions.polygon_count() ? ",\n" : "\n";
  }
  text += "]}\n";
  return text;
}

std::string geojson_crs_code(const std::string& crs_wkt) {
  if (crs_wkt.empty()) return {};
  GdalMessages messages;
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  std::string code;
  if (crs.importFromWkt(crs_wkt.c_str()) == OGRERR_NONE) code = crs_code(crs);
  if (code.empty()) {
    throw IoError("GeoJSON names a coordinate system by its code, but " + crs_name(crs_wkt) +
                  " has none; write .gpkg, .fgb or .shp instead");
  }
  return code;
}

}  // namespace oblast::io
