// Writes Shapefile, GeoPackage and FlatGeobuf with GDAL.
#include "io/gdal_writer.h"

#include <ogrsf_frmts.h>

#include <limits>
#include <memory>

#include "io/gdal_output.h"
#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

namespace {

void write_features(OGRLayer& layer, const RegionView& regions, std::span<const std::int32_t> numbers,
                    Direction direction, const Check& check) {
  std::vector<Point> scratch;
  for (std::size_t p = 0; p < regions.polygon_count(); ++p) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField(0, numbers.empty() ? static_cast<int>(p) : numbers[p]);
    feature.SetGeometryDirectly(make_polygon(regions, p, direction, scratch).release());
    check(layer.CreateFeature(&feature) == OGRERR_NONE);
  }
}

void check_complete(const GdalLayer& what, const RegionView& regions, std::vector<std::string>* notes) {
  WrittenLayer written(what);
  ChangedVertices changed(what.driver, regions);
  std::uint64_t features = 0;
  std::uint64_t vertices = 0;
  while (const std::unique_ptr<OGRFeature> feature{written.layer().GetNextFeature()}) {
    ++features;
    vertices += vertex_count(feature->GetGeometryRef());
    changed.add(feature->GetGeometryRef());
  }
  written.check()(true);
  if (features != regions.polygon_count() || vertices != regions.points.size()) {
    throw IoError("cannot write " + what.name + ": what was written does not read back whole (is the disk full?)");
  }
  if (notes && !changed.note().empty()) notes->push_back(changed.note());
}

}  // namespace

void write_with_gdal(const GdalLayer& what, const RegionView& regions, std::span<const std::int32_t> numbers,
                     std::vector<std::string>* notes) {
  register_gdal_drivers();
  if (regions.polygon_count() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw IoError("cannot write " + what.name + ": more than 2^31 - 1 polygons");
  }
  {
    GdalOutputFile file(what, wkbPolygon, {});
    OGRFieldDefn number("polygon", OFTInteger);
    file.check()(file.layer().CreateField(&number) == OGRERR_NONE);
    file.begin_features();
    const bool shapefile = what.driver == "ESRI Shapefile";
    write_features(file.layer(), regions, numbers, shapefile ? Direction::esri : Direction::as_given, file.check());
    file.close();
  }
  check_complete(what, regions, notes);
}

}  // namespace oblast::io
