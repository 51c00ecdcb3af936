#include "io/write_points.h"

#include <fmt/format.h>

#include "io/formats.h"
#include "io/gdal_output.h"
#include "io/gdal_output_file.h"
#include "io/gdal_session.h"
#include "io/write_text.h"

namespace oblast::io {

namespace {

std::string to_wkt(std::span<const Point> points) {
  std::string text;
  for (const Point& p : points) text += fmt::format("POINT ({} {})\n", p.x, p.y);
  return text;
}

OGRFieldType type_of(const PointColumn& column) {
  constexpr OGRFieldType types[] = {OFTString, OFTInteger64, OFTReal};
  return types[column.values.index()];
}

void set_field(OGRFeature& feature, int field, const PointColumn& column, std::size_t i) {
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

void write_features(OGRLayer& layer, std::span<const Point> points, std::span<const PointColumn> columns,
                    const Check& check) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    OGRFeature feature(layer.GetLayerDefn());
    for (std::size_t c = 0; c < columns.size(); ++c) set_field(feature, static_cast<int>(c), columns[c], i);
    const OGRPoint point(points[i].x, points[i].y);
    check(feature.SetGeometry(&point) == OGRERR_NONE);
    check(layer.CreateFeature(&feature) == OGRERR_NONE);
  }
}

void write_with_driver(const GdalLayer& what, std::span<const Point> points, std::span<const PointColumn> columns) {
  register_gdal_drivers();
  GdalOutputFile file(what, wkbPoint, {});
  for (const PointColumn& column : columns) {
    OGRFieldDefn field(column.name.c_str(), type_of(column));
    file.check()(file.layer().CreateField(&field) == OGRERR_NONE);
  }
  file.begin_features();
  write_features(file.layer(), points, columns, file.check());
  file.close();
}

}  // namespace

void write_points(const std::string& path_given, std::span<const Point> points, std::span<const PointColumn> columns,
                  const WriteOptions& options) {
  check_writable(path_given, options);
  if (path_given == "-") return write_text_to_standard_output(to_wkt(points));
  const OutputTarget target = output_target(path_given);
  write_staged(target, options, [&](const std::string& stage) {
    if (is_wkt(target.path)) return write_text(stage, to_wkt(points), target.path);
    const char* const driver = format_of(target.path)->writer;
    if (!driver && !is_geojson(target.path))
      throw IoError("cannot write points to " + target.path + "; choose .gpkg, .shp, .geojson, .fgb or .wkt");
    write_with_driver({stage, driver ? driver : "GeoJSON", target.layer_name(), options.crs_wkt, target.path}, points,
                      columns);
  });
}

}  // namespace oblast::io
