#include "io/write_points.h"

#include <fmt/format.h>

#include <functional>
#include <memory>

#include "io/formats.h"
#include "io/gdal_output.h"
#include "io/gdal_output_file.h"
#include "io/gdal_session.h"
#include "io/write_text.h"

namespace oblast::io {

namespace {

// What is written: points or lines.
struct Places {
  const char* what;  // for messages
  OGRwkbGeometryType type;
  std::size_t count;
  std::function<std::unique_ptr<OGRGeometry>(std::size_t)> geometry;
  std::function<void(std::string& text, std::size_t)> append_wkt;
};

std::string to_wkt(const Places& places) {
  std::string text;
  for (std::size_t i = 0; i < places.count; ++i) {
    places.append_wkt(text, i);
    text += '\n';
  }
  return text;
}

OGRFieldType type_of(const PlaceColumn& column) {
  constexpr OGRFieldType types[] = {OFTString, OFTInteger64, OFTReal};
  return types[column.values.index()];
}

void set_field(OGRFeature& feature, int field, const PlaceColumn& column, std::size_t i) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values)) {
    feature.SetField(field, (*texts)[i].c_str());
  } else if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values)) {
    if ((*integers)[i] == no_value)
      feature.SetFieldNull(field);
    else
      feature.SetField(field, static_cast<GIntBig>((*integers)[i]));
  } else {
    feature.SetField(field, std::get<std::vector<double>>(column.values)[i]);
  }
}

void write_features(OGRLayer& layer, const Places& places, std::span<const PlaceColumn> columns, const Check& check) {
  for (std::size_t i = 0; i < places.count; ++i) {
    OGRFeature feature(layer.GetLayerDefn());
    for (std::size_t c = 0; c < columns.size(); ++c) set_field(feature, static_cast<int>(c), columns[c], i);
    check(feature.SetGeometryDirectly(places.geometry(i).release()) == OGRERR_NONE);
    check(layer.CreateFeature(&feature) == OGRERR_NONE);
  }
}

void write_with_driver(const GdalLayer& what, const Places& places, std::span<const PlaceColumn> columns) {
  register_gdal_drivers();
  GdalOutputFile file(what, places.type, {});
  for (const PlaceColumn& column : columns) {
    OGRFieldDefn field(column.name.c_str(), type_of(column));
    file.check()(file.layer().CreateField(&field) == OGRERR_NONE);
  }
  file.begin_features();
  write_features(file.layer(), places, columns, file.check());
  file.close();
}

void write_places(const std::string& path_given, const Places& places, std::span<const PlaceColumn> columns,
                  const WriteOptions& options) {
  check_writable(path_given, options);
  if (path_given == "-") return write_text_to_standard_output(to_wkt(places));
  const OutputTarget target = output_target(path_given);
  write_staged(target, options, [&](const std::string& stage) {
    if (is_wkt(target.path)) return write_text(stage, to_wkt(places), target.path);
    const char* const driver = format_of(target.path)->writer;
    if (!driver && !is_geojson(target.path))
      throw IoError(
          fmt::format("cannot write {} to {}; choose .gpkg, .shp, .geojson, .fgb or .wkt", places.what, target.path));
    write_with_driver({stage, driver ? driver : "GeoJSON", target.layer_name(), options.crs_wkt, target.path}, places,
                      columns);
  });
}

}  // namespace

void write_points(const std::string& path, std::span<const Point> points, std::span<const PlaceColumn> columns,
                  const WriteOptions& options) {
  const auto geometry = [&](std::size_t i) { return std::make_unique<OGRPoint>(points[i].x, points[i].y); };
  const auto append_wkt = [&](std::string& text, std::size_t i) {
    text += fmt::format("POINT ({} {})", points[i].x, points[i].y);
  };
  write_places(path, {"points", wkbPoint, points.size(), geometry, append_wkt}, columns, options);
}

void write_lines(const std::string& path, const LineView& lines, std::span<const PlaceColumn> columns,
                 const WriteOptions& options) {
  const auto vertices = [&](std::size_t i) {
    const std::uint32_t begin = i == 0 ? 0 : lines.ends[i - 1];
    return lines.vertices.subspan(begin, lines.ends[i] - begin);
  };
  const auto geometry = [&](std::size_t i) {
    auto line = std::make_unique<OGRLineString>();
    for (const Point& p : vertices(i)) line->addPoint(p.x, p.y);
    return line;
  };
  const auto append_wkt = [&](std::string& text, std::size_t i) {
    text += "LINESTRING (";
    const char* comma = "";
    for (const Point& p : vertices(i)) {
      text += fmt::format("{}{} {}", comma, p.x, p.y);
      comma = ", ";
    }
    text += ')';
  };
  write_places(path, {"lines", wkbLineString, lines.ends.size(), geometry, append_wkt}, columns, options);
}

}  // namespace oblast::io
