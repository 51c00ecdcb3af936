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

#include "io/crs.h"
#include "io/crs_reader.h"
#include "io/flatgeobuf_order.h"
#include "io/formats.h"
#include "io/gdal_source.h"
#include "io/layer_builder.h"
#include "io/shapefile_check.h"

namespace oblast::io {

namespace {

void add_rings(const OGRPolygon& polygon, LayerBuilder& builder, std::vector<Point>& scratch) {
  for (const OGRLinearRing* ring : polygon) {
    scratch.resize(ring->getNumPoints());
    if (!scratch.empty()) ring->getPoints(&scratch[0].x, sizeof(Point), &scratch[0].y, sizeof(Point));
    builder.add_ring(scratch);
  }
}

void add_polygon(const OGRPolygon& polygon, LayerBuilder& builder, std::vector<Point>& scratch) {
  builder.begin_polygon();
  add_rings(polygon, builder, scratch);
  builder.end_polygon();
}

[[noreturn]] void refuse_type(const OGRGeometry& geometry, const LayerBuilder& builder) {
  const std::string type = geometry.getGeometryName();
  if (OGR_GT_IsNonLinear(geometry.getGeometryType())) {
    builder.refuse(type + " is a curve type: only straight edges are read; convert it to POLYGON first");
  }
  builder.refuse(type + " is not a polygon of the plane");
}

// The recursion is shallow: GDAL's readers accept collections that are nested a few dozen levels deep at most.
void add_geometry(const OGRGeometry& geometry, LayerBuilder& builder, std::vector<Point>& scratch) {
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPolygon:
      return add_polygon(*geometry.toPolygon(), builder, scratch);
    case wkbMultiPolygon:
      for (const OGRPolygon* polygon : geometry.toMultiPolygon()) add_polygon(*polygon, builder, scratch);
      return;
    case wkbGeometryCollection:
      for (const OGRGeometry* member : geometry.toGeometryCollection()) add_geometry(*member, builder, scratch);
      return;
    case wkbLineString:
    case wkbMultiLineString:
      return builder.line(geometry.getGeometryName());
    case wkbPoint:
    case wkbMultiPoint:
      return builder.point(geometry.getGeometryName());
    default:
      refuse_type(geometry, builder);
  }
}

// A record of a shapefile: all its rings are one polygon (see above).
void add_record(const OGRGeometry& geometry, LayerBuilder& builder, std::vector<Point>& scratch) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type != wkbMultiPolygon && type != wkbGeometryCollection) return add_geometry(geometry, builder, scratch);
  builder.begin_polygon();
  for (const OGRGeometry* member : *geometry.toGeometryCollection()) {
    if (wkbFlatten(member->getGeometryType()) != wkbPolygon) refuse_type(*member, builder);
    add_rings(*member->toPolygon(), builder, scratch);
  }
  builder.end_polygon();
}

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

void read_layer(OGRLayer& source, const File& file, const GdalMessages& messages, const ReadOptions& options,
                Layer& layer) {
  LayerBuilder builder(layer, static_cast<std::uint32_t>(layer.files.size() - 1), options);
  if (file.shapefile) builder.turn_rings();
  const std::uint64_t features_before = layer.report.features;
  std::vector<Point> scratch;
  const bool reorder = file.flatgeobuf && options.entries == FeatureEntries::with_polygons && options.where.empty();
  FlatgeobufOrder order(reorder ? source.GetLayerDefn()->GetFieldIndex("polygon") : -1, layer);
  if (options.where.empty()) ignore_attributes(source, file.flatgeobuf ? "polygon" : "");
  const auto check = [&](const std::string& place) {
    if (messages.failed()) throw IoError(place + ": cannot be read to the end: " + messages.text(""));
  };

  while (const std::unique_ptr<OGRFeature> feature{source.GetNextFeature()}) {
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
    order.add(*feature);
  }
  check(layer.files.back());
  if (file.flatgeobuf && options.where.empty())
    check_count(source, layer.report.features - features_before, layer.files.back());
  order.restore();
}

}  // namespace

Layer read_with_gdal(const std::string& path, const ReadOptions& options) {
  const File file{lower_extension(path) == ".shp", lower_extension(path) == ".fgb"};
  if (file.shapefile) check_shapefile(path);
  GdalSource source(path);
  Layer layer;
  CommonCrs crs;
  for (const GdalSource::Entry& entry : source.layers()) {
    layer.files.push_back(entry.name);
    crs.add(read_crs(*entry.layer, path), layer.files.back());
    set_condition(entry, options.where, source.messages());
    source.messages().clear();  // the file was opened in spite of these messages
    read_layer(*entry.layer, file, source.messages(), options, layer);
  }
  layer.crs_wkt = crs.wkt();
  return layer;
}

}  // namespace oblast::io
