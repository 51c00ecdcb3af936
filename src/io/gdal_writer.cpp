// Writes Shapefile, GeoPackage and FlatGeobuf with GDAL.
#include "io/gdal_writer.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>

#include "io/formats.h"
#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

namespace {

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetCloser>;

double twice_signed_area(std::span<const Point> contour) {
  double sum = 0;
  Point previous = contour.back();
  for (const Point& p : contour) {
    sum += (previous.x - contour[0].x) * (p.y - contour[0].y) - (p.x - contour[0].x) * (previous.y - contour[0].y);
    previous = p;
  }
  return sum;
}

// The directions of contours in a file.
enum class Direction {
  as_given,  ///< a result's: outer anticlockwise, holes clockwise
  esri,      ///< Shapefile demands the outer contour clockwise and holes anticlockwise
};

// The contour as a closed ring. If it is reversed, its first vertex stays the first.
void add_ring(OGRPolygon& polygon, std::span<const Point> contour, bool reverse, std::vector<Point>& scratch) {
  scratch.assign(contour.begin(), contour.end());
  if (reverse) std::reverse(scratch.begin() + 1, scratch.end());
  scratch.push_back(contour.front());
  auto ring = std::make_unique<OGRLinearRing>();
  const auto count = static_cast<int>(scratch.size());
  ring->setNumPoints(count, FALSE);
  for (int i = 0; i < count; ++i) ring->setPoint(i, scratch[i].x, scratch[i].y);
  polygon.addRingDirectly(ring.release());
}

std::unique_ptr<OGRPolygon> make_polygon(const RegionView& regions, std::size_t p, Direction direction,
                                         std::vector<Point>& scratch) {
  auto polygon = std::make_unique<OGRPolygon>();
  bool outer = true;
  for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c) {
    const auto contour = regions.contour(c);
    if (contour.empty()) continue;
    const double area = direction == Direction::esri ? twice_signed_area(contour) : 0;
    add_ring(*polygon, contour, outer ? area > 0 : area < 0, scratch);
    outer = false;
  }
  return polygon;
}

// GDAL reports errors by return value, by message, or by both. Either is an error here.
class Check {
 public:
  Check(const GdalMessages& messages, const std::string& name) : messages_(messages), name_(name) {}
  void operator()(bool good) const {
    if (good && !messages_.failed()) return;
    throw IoError("cannot write " + name_ + ": " + messages_.text("GDAL failed and gave no reason"));
  }

 private:
  const GdalMessages& messages_;
  const std::string& name_;
};

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
  const auto count = [&](const OGRPolygon& polygon) {
    for (const OGRLinearRing* ring : polygon) vertices += ring->getNumPoints() - 1;  // it is closed
  };
  while (const std::unique_ptr<OGRFeature> feature{dataset->GetLayer(0)->GetNextFeature()}) {
    ++features;
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (!geometry) continue;
    if (wkbFlatten(geometry->getGeometryType()) == wkbPolygon) {
      count(*geometry->toPolygon());
    } else {
      for (const OGRGeometry* part : *geometry->toGeometryCollection()) count(*part->toPolygon());
    }
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
