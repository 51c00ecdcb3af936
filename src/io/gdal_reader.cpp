// Reads one file with GDAL: layers, features, geometries, in the order of the file.
//
// Shapefiles. A record is a list of rings. It does not say which ring is a hole of which. In ESRI's description outer
// rings run clockwise and holes counter-clockwise, and outer rings of one record do not overlap. So the region of a
// record is the even-odd of its rings, however they are grouped. GDAL groups them into polygons by direction and
// containment. That takes quadratic time in the worst case, and is a guess if the writer used wrong directions. Here
// GDAL is told not to group, and each record becomes one polygon. Its rings are reversed: then outer rings run
// counter-clockwise, as in all other formats.
#include "io/gdal_reader.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>

#include "io/attribute_data.h"
#include "io/crs_reader.h"
#include "io/flatgeobuf_order.h"
#include "io/formats.h"
#include "io/gdal_geometry.h"
#include "io/gdal_source.h"
#include "io/geopackage_check.h"
#include "io/layer_builder.h"
#include "io/shapefile_check.h"

namespace oblast::io {

namespace {

void ignore_attributes(OGRLayer& layer, const std::string& except) {
  if (!layer.TestCapability(OLCIgnoreFields)) return;
  std::vector<const char*> names;
  const OGRFeatureDefn* definition = layer.GetLayerDefn();
  for (int i = 0; i < definition->GetFieldCount(); ++i) {
    const char* name = definition->GetFieldDefn(i)->GetNameRef();
    if (name != except) names.push_back(name);
  }
  names.push_back("OGR_STYLE");
  names.push_back(nullptr);
  layer.SetIgnoredFields(names.data());
}

struct File {
  bool shapefile = false;
  bool flatgeobuf = false;
};

// If a FlatGeobuf file is cut off in its index, GDAL reads an empty layer. But the header still has the number of
// features (0 means unknown).
void check_count(OGRLayer& source, std::uint64_t features, const std::string& file) {
  const auto declared = static_cast<std::uint64_t>(std::max<GIntBig>(0, source.GetFeatureCount(FALSE)));
  if (declared == 0 || declared == features) return;
  throw IoError(file + " is truncated: its header declares " + std::to_string(declared) + " features, but only " +
                std::to_string(features) + " can be read; copy or export the file again");
}

// Says again and again what share of the features has been read, if their number is known without reading them.
class ReadCount {
 public:
  ReadCount(OGRLayer& layer, const std::function<void(double share)>& progress) : progress_(progress) {
    if (progress_ && layer.TestCapability(OLCFastFeatureCount)) features_ = layer.GetFeatureCount(FALSE);
  }
  void add() {
    constexpr GIntBig step = 1024;
    if (++done_ % step == 0 && features_ > 0)
      progress_(std::min(1.0, static_cast<double>(done_) / static_cast<double>(features_)));
  }

 private:
  const std::function<void(double share)>& progress_;
  GIntBig features_ = 0, done_ = 0;
};

void read_layer(GdalSource& source, const File& file, const ReadOptions& options, FileTable* table, Layer& layer,
                const std::function<void(double share)>& progress) {
  OGRLayer& from = source.layer();
  GdalMessages& messages = source.messages();
  LayerBuilder builder(layer, 0, options);
  builder.set_crs(layer.crs_wkt);
  if (file.shapefile) builder.turn_rings();
  std::vector<Point> scratch;
  const bool reorder = file.flatgeobuf && options.entries == FeatureEntries::with_polygons && options.where.empty();
  FlatgeobufOrder order(reorder ? from.GetLayerDefn()->GetFieldIndex("polygon") : -1, layer);
  if (options.where.empty() && !table) ignore_attributes(from, file.flatgeobuf ? "polygon" : "");
  ReadCount count(from, progress);
  const auto check = [&](const std::string& place) {
    if (messages.failed()) throw IoError(place + ": cannot be read to the end: " + messages.text(""));
  };

  while (std::unique_ptr<OGRFeature> feature{from.GetNextFeature()}) {
    builder.begin_feature(feature->GetFID());
    check(builder.where());
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (!geometry) {
      builder.null_geometry();
    } else {
      if (geometry->Is3D()) builder.with_z();
      if (geometry->IsMeasured()) builder.with_m();
      file.shapefile ? add_record(*geometry, builder, scratch) : add_geometry(*geometry, builder, scratch);
    }
    builder.end_feature();
    count.add();
    order.add(*feature);
    if (!table) continue;
    feature->SetGeometryDirectly(nullptr);
    table->rows.push_back(std::move(feature));
  }
  check(layer.files.front());
  if (file.flatgeobuf && options.where.empty()) check_count(from, layer.report.features, layer.files.front());
  order.restore();
  builder.finish();
}

}  // namespace

void name_columns(Layer& layer, const std::vector<Column>& columns) {
  const bool is_ours = columns.size() == 1 && columns[0].name == "polygon";
  if (is_ours) return;
  for (const Column& column : columns) layer.columns.push_back(column.name);
}

Layer read_with_gdal(const NamedSource& named, const ReadOptions& options, Attributes attributes, FileTable& table) {
  const std::string& path = named.source.path;
  const File file{lower_extension(path) == ".shp", lower_extension(path) == ".fgb"};
  if (file.shapefile) check_shapefile(path);
  if (lower_extension(path) == ".gpkg") check_geopackage(path);
  GdalSource source(named.source, named.name);
  Layer layer;
  layer.files.push_back(named.name);
  layer.notes = source.notes();
  layer.crs_wkt = read_crs(source.layer(), path);
  const OGRFeatureDefn& definition = *source.layer().GetLayerDefn();
  for (int f = 0; f < definition.GetFieldCount(); ++f) table.columns.push_back(column_of(*definition.GetFieldDefn(f)));
  source.set_condition(options.where);
  source.messages().clear();  // the file was opened in spite of these messages
  read_layer(source, file, options, attributes == Attributes::keep ? &table : nullptr, layer, named.progress);
  name_columns(layer, table.columns);
  return layer;
}

}  // namespace oblast::io
