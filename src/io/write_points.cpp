#include "io/write_points.h"

#include <cpl_string.h>
#include <fmt/format.h>

#include <filesystem>

#include "io/formats.h"
#include "io/gdal_output.h"
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

void write_with_driver(const std::string& stage, const char* driver_name, std::span<const Point> points,
                       std::span<const PointColumn> columns, const WriteOptions& options, const std::string& name) {
  register_gdal_drivers();
  GdalMessages messages;
  const ThreadOption no_listing("GDAL_DISABLE_READDIR_ON_OPEN", "TRUE");
  const ThreadOption no_sync("OGR_SQLITE_SYNCHRONOUS", "OFF");
  const Check check(messages, name);
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (!options.crs_wkt.empty()) check(crs.importFromWkt(options.crs_wkt.c_str()) == OGRERR_NONE);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  check(driver != nullptr);
  Dataset dataset(driver->Create(stage.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  check(dataset != nullptr);
  CPLStringList layer_options;
  if (std::string_view(driver_name) == "ESRI Shapefile") layer_options.SetNameValue("ENCODING", "UTF-8");
  OGRLayer* layer = dataset->CreateLayer(std::filesystem::path(name).stem().string().c_str(),
                                         options.crs_wkt.empty() ? nullptr : &crs, wkbPoint, layer_options.List());
  check(layer != nullptr);
  for (const PointColumn& column : columns) {
    OGRFieldDefn field(column.name.c_str(), type_of(column));
    check(layer->CreateField(&field) == OGRERR_NONE);
  }
  const bool transactions = dataset->TestCapability(ODsCTransactions) != 0;
  if (transactions) check(dataset->StartTransaction() == OGRERR_NONE);
  write_features(*layer, points, columns, check);
  if (transactions) check(dataset->CommitTransaction() == OGRERR_NONE);
  dataset.reset();  // the headers are written here
  check(true);
}

}  // namespace

void write_points(const std::string& path_given, std::span<const Point> points, std::span<const PointColumn> columns,
                  const WriteOptions& options) {
  check_writable(path_given, options);
  if (path_given == "-") return write_text_to_standard_output(to_wkt(points));
  const std::string path = target_of(path_given);
  write_staged(path, options.existing, [&](const std::string& stage) {
    if (is_wkt(path)) return write_text(stage, to_wkt(points), path);
    const char* const driver = format_of(path)->writer;
    write_with_driver(stage, driver ? driver : "GeoJSON", points, columns, options, path);
  });
}

}  // namespace oblast::io
