// Writes Shapefile, GeoPackage and FlatGeobuf with GDAL.
#include "io/gdal_writer.h"

#include <ogrsf_frmts.h>

#include <filesystem>
#include <limits>
#include <memory>

#include "io/formats.h"
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

// Buffered data can be lost when a file is closed on a full disk, and not every driver reports this. So the file is
// read back.
void check_complete(const std::string& path, const char* driver, const RegionView& regions, const std::string& name) {
  GdalMessages messages;
  const ThreadOption no_grouping("OGR_ORGANIZE_POLYGONS", "SKIP");
  const char* const drivers[] = {driver, nullptr};
  const ThreadOption no_comparing("USE_OSR_FIND_MATCHES", "NO");  // of the .prj with all systems there are
  const Check check(messages, name);
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers));
  check(dataset && dataset->GetLayerCount() == 1);
  std::uint64_t features = 0;
  std::uint64_t vertices = 0;
  while (const std::unique_ptr<OGRFeature> feature{dataset->GetLayer(0)->GetNextFeature()}) {
    ++features;
    vertices += vertex_count(feature->GetGeometryRef());
  }
  check(true);
  if (features != regions.polygon_count() || vertices != regions.points.size()) {
    throw IoError("cannot write " + name + ": what was written does not read back whole (is the disk full?)");
  }
}

}  // namespace

void write_with_gdal(const std::string& path, const char* driver_name, const RegionView& regions,
                     const std::string& crs_wkt, const std::string& name, std::span<const std::int32_t> numbers) {
  register_gdal_drivers();
  if (regions.polygon_count() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw IoError("cannot write " + name + ": more than 2^31 - 1 polygons");
  }
  {
    GdalMessages messages;
    const ThreadOption no_listing("GDAL_DISABLE_READDIR_ON_OPEN", "TRUE");
    // The file has no older contents to protect, and is renamed only after it is complete.
    const ThreadOption no_sync("OGR_SQLITE_SYNCHRONOUS", "OFF");
    // The rings have the right directions already. GDAL would compare every ring of a polygon with every other.
    const ThreadOption no_rewind("SHAPE_REWIND_ON_WRITE", "NO");
    const Check check(messages, name);

    OGRSpatialReference crs;
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (!crs_wkt.empty()) check(crs.importFromWkt(crs_wkt.c_str()) == OGRERR_NONE);

    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
    check(driver != nullptr);
    Dataset dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    check(dataset != nullptr);
    const std::string layer_name = std::filesystem::path(path).stem().string();
    OGRLayer* layer = dataset->CreateLayer(layer_name.c_str(), crs_wkt.empty() ? nullptr : &crs, wkbPolygon, nullptr);
    check(layer != nullptr);
    OGRFieldDefn number("polygon", OFTInteger);
    check(layer->CreateField(&number) == OGRERR_NONE);

    const bool transactions = dataset->TestCapability(ODsCTransactions) != 0;
    if (transactions) check(dataset->StartTransaction() == OGRERR_NONE);
    const bool shapefile = std::string_view(driver_name) == "ESRI Shapefile";
    write_features(*layer, regions, numbers, shapefile ? Direction::esri : Direction::as_given, check);
    if (transactions) check(dataset->CommitTransaction() == OGRERR_NONE);
    dataset.reset();  // the spatial index and the headers are written here
    check(true);
  }
  check_complete(path, driver_name, regions, name);
}

}  // namespace oblast::io
