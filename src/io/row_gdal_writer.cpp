// Rows in the formats that GDAL writes.
#include <cpl_string.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "io/attribute_data.h"
#include "io/gdal_output_file.h"
#include "io/geopackage_writer.h"
#include "io/row_fields.h"
#include "io/row_writers.h"

namespace oblast::io {

namespace {

bool equal_without_case(const std::string& a, const std::string& b) { return EQUAL(a.c_str(), b.c_str()); }

// A name that no column has.
std::string free_name(const std::string& wanted, const FieldPlan& plan) {
  std::string name = wanted;
  while (std::any_of(plan.fields.begin(), plan.fields.end(),
                     [&](const Column& field) { return equal_without_case(field.name, name); }))
    name += '_';
  return name;
}

// GDAL leaves features without geometry out of FlatGeobuf, and does not say so.
void refuse_empty_rows(const RowOutput& output) {
  for (std::size_t row = 0; row < output.rows.feature_count(); ++row) {
    if (output.rows.feature_begin(row) == output.rows.feature_end(row))
      throw IoError(
          fmt::format("cannot write {}: row {} has no polygons, and FlatGeobuf does not keep such rows; write "
                      ".gpkg instead",
                      output.name, row));
  }
}

CPLStringList layer_options(const std::string& driver, const FieldPlan& plan) {
  CPLStringList options;
  if (driver == "ESRI Shapefile") options.SetNameValue("ENCODING", "UTF-8");
  if (driver == "GPKG") {
    options.SetNameValue("FID", free_name("fid", plan).c_str());
    options.SetNameValue("GEOMETRY_NAME", free_name("geom", plan).c_str());
  }
  return options;
}

void write_features(OGRLayer& layer, const RowOutput& output, const RowFields& fields, Direction direction,
                    const Check& check) {
  std::vector<Point> scratch;
  const FeatureView& rows = output.rows;
  for (std::size_t row = 0; row < rows.feature_count(); ++row) {
    OGRFeature feature(layer.GetLayerDefn());
    fields.fill(feature, row);
    const std::size_t begin = rows.feature_begin(row), end = rows.feature_end(row);
    if (begin < end) {
      auto geometry = std::make_unique<OGRMultiPolygon>();
      for (std::size_t p = begin; p < end; ++p)
        geometry->addGeometryDirectly(make_polygon(rows.regions, p, direction, scratch).release());
      feature.SetGeometryDirectly(geometry.release());
    }
    check(layer.CreateFeature(&feature) == OGRERR_NONE);
  }
}

void create_fields(OGRLayer& layer, const FieldPlan& plan, const Check& check) {
  for (const Column& field : plan.fields) {
    OGRFieldDefn defined(field.name.c_str(), OFTString);
    define(defined, field);
    check(layer.CreateField(&defined) == OGRERR_NONE);
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    const std::string made = definition.GetFieldDefn(definition.GetFieldCount() - 1)->GetNameRef();
    if (made != field.name)
      throw IoError(fmt::format("cannot write column {}: GDAL would call it {}; rename it", field.name, made));
  }
}

// See WrittenLayer. Attributes are compared as well, where the file keeps the order of the rows.
void check_complete(const GdalLayer& what, const RowOutput& output, const RowFields& fields,
                    OGRFeatureDefn& given_fields, std::vector<std::string>& notes) {
  WrittenLayer written(what);
  const bool in_order = what.driver != "FlatGeobuf";
  ChangedValues changed(fields, *written.layer().GetLayerDefn());
  ChangedVertices moved(what.driver, output.rows.regions);
  std::size_t row = 0;
  std::uint64_t vertices = 0;
  while (const std::unique_ptr<OGRFeature> feature{written.layer().GetNextFeature()}) {
    vertices += vertex_count(feature->GetGeometryRef());
    moved.add(feature->GetGeometryRef());
    if (in_order && row < output.rows.feature_count()) {
      OGRFeature given(&given_fields);
      fields.fill(given, row);
      changed.compare(given, *feature);
    }
    ++row;
  }
  written.check()(true);
  if (row != output.rows.feature_count() || vertices != output.rows.regions.points.size())
    throw IoError("cannot write " + output.name + ": what was written does not read back whole (is the disk full?)");
  const std::vector<std::string> more = changed.notes(fields);
  notes.insert(notes.end(), more.begin(), more.end());
  if (!moved.note().empty()) notes.push_back(moved.note());
}

// GDAL makes the layer, and SQLite fills it.
void write_geopackage(const GdalLayer& what, const RowOutput& output, GeopackageShape shape, const RowFields& fields,
                      OGRFeatureDefn& given, std::vector<std::string>& notes) {
  GdalOutputFile file(what, shape == GeopackageShape::polygon ? wkbPolygon : wkbMultiPolygon,
                      layer_options(what.driver, fields.plan()));
  create_fields(file.layer(), fields.plan(), file.check());
  const GeopackageRows rows{
      what,           output.rows, fields, given, shape, file.layer().GetFIDColumn(), file.layer().GetGeometryColumn(),
      output.progress};
  file.close();
  write_rows(rows);
  const std::vector<std::uint64_t> lost = check_rows(rows);
  ChangedValues changed(fields);
  for (std::size_t column = 0; column < lost.size(); ++column) changed.add(column, lost[column]);
  const std::vector<std::string> more = changed.notes(fields);
  notes.insert(notes.end(), more.begin(), more.end());
}

struct Release {
  void operator()(OGRFeatureDefn* definition) const { definition->Release(); }
};

}  // namespace

void write_rows_with_gdal(const GdalLayer& what, const RowOutput& output, GeopackageShape shape,
                          std::vector<std::string>& notes) {
  register_gdal_drivers();
  if (what.driver == "FlatGeobuf") refuse_empty_rows(output);
  const FieldPlan plan = plan_fields(output.columns, what.path);
  const RowFields fields(output.columns, plan);
  notes.insert(notes.end(), plan.notes.begin(), plan.notes.end());
  std::unique_ptr<OGRFeatureDefn, Release> given(OGRFeatureDefn::CreateFeatureDefn("given"));
  given->Reference();
  given->SetGeomType(wkbNone);
  for (const Column& field : plan.fields) {
    OGRFieldDefn defined(field.name.c_str(), OFTString);
    define(defined, field);
    given->AddFieldDefn(&defined);
  }
  if (what.driver == "GPKG" && can_write_rows(plan))
    return write_geopackage(what, output, shape, fields, *given, notes);
  {
    const bool shapefile = what.driver == "ESRI Shapefile";
    GdalOutputFile file(what, shapefile ? wkbPolygon : wkbMultiPolygon, layer_options(what.driver, plan));
    create_fields(file.layer(), plan, file.check());
    file.begin_features();
    write_features(file.layer(), output, fields, shapefile ? Direction::esri : Direction::as_given, file.check());
    file.close();
  }
  check_complete(what, output, fields, *given, notes);
}

}  // namespace oblast::io
