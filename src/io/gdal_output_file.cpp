// Creating and reading back; see gdal_output_file.h.
#include "io/gdal_output_file.h"

#include <cpl_conv.h>
#include <fmt/format.h>

#include <filesystem>

#include "io/crs_code.h"

namespace oblast::io {

namespace {

// GeoPackage has the moment of the last change. It would make two files of the same result differ, so it is a fixed
// one, unless the user has chosen another.
const char* date_of_change() { return CPLGetConfigOption("OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z"); }

int index_of(GDALDataset& dataset, const std::string& layer) {
  for (int i = 0; i < dataset.GetLayerCount(); ++i) {
    if (EQUAL(dataset.GetLayer(i)->GetName(), layer.c_str())) return i;
  }
  return -1;
}

}  // namespace

GdalOutputFile::GdalOutputFile(const GdalLayer& what, OGRwkbGeometryType type, CPLStringList options)
    : date_("OGR_CURRENT_DATE", std::string(date_of_change()).c_str()), check_(messages_, what.name) {
  OGRSpatialReference crs;
  if (!what.crs_wkt.empty()) check_(import_crs(crs, what.crs_wkt));
  open(what);
  layer_ = dataset_->CreateLayer(what.layer.c_str(), what.crs_wkt.empty() ? nullptr : &crs, type, options.List());
  check_(layer_ != nullptr);
}

void GdalOutputFile::open(const GdalLayer& what) {
  std::error_code error;
  if (std::filesystem::exists(what.path, error)) {
    const char* const drivers[] = {what.driver.c_str(), nullptr};
    dataset_.reset(
        GDALDataset::Open(what.path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE | GDAL_OF_VERBOSE_ERROR, drivers));
    check_(dataset_ != nullptr);
    const int old = index_of(*dataset_, what.layer);
    if (old >= 0) check_(dataset_->DeleteLayer(old) == OGRERR_NONE);
    return;
  }
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(what.driver.c_str());
  if (!driver)
    throw IoError(fmt::format("cannot write {}: this build of GDAL has no driver {}; write .gpkg or .fgb instead",
                              what.name, what.driver));
  dataset_.reset(driver->Create(what.path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  check_(dataset_ != nullptr);
}

void GdalOutputFile::begin_features() {
  transaction_ = dataset_->TestCapability(ODsCTransactions) != 0;
  if (transaction_) check_(dataset_->StartTransaction() == OGRERR_NONE);
}

void GdalOutputFile::close() {
  if (transaction_) check_(dataset_->CommitTransaction() == OGRERR_NONE);
  dataset_.reset();  // the spatial index and the headers are written here
  check_(true);
}

WrittenLayer::WrittenLayer(const GdalLayer& what) : check_(messages_, what.name) {
  const char* const drivers[] = {what.driver.c_str(), nullptr};
  dataset_.reset(GDALDataset::Open(what.path.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers));
  check_(dataset_ != nullptr);
  const int index = dataset_->GetLayerCount() == 1 ? 0 : index_of(*dataset_, what.layer);
  check_(index >= 0);
  layer_ = dataset_->GetLayer(index);
}

void ChangedVertices::add(const OGRGeometry* geometry) {
  if (!compares_ || !geometry) return;
  if (wkbFlatten(geometry->getGeometryType()) == wkbPolygon) return add_polygon(*geometry->toPolygon());
  for (const OGRGeometry* part : *geometry->toGeometryCollection()) add_polygon(*part->toPolygon());
}

void ChangedVertices::add_polygon(const OGRPolygon& polygon) {
  for (const OGRLinearRing* ring : polygon) {
    for (int i = 0; i + 1 < ring->getNumPoints() && next_ < given_.points.size(); ++i, ++next_)
      changed_ += given_.points[next_] != Point{ring->getX(i), ring->getY(i)};
  }
}

std::string ChangedVertices::note() const {
  if (changed_ == 0) return {};
  return fmt::format(
      "rounded vertices: {} of {}, because the format has fewer digits than a double; borders may cross there now "
      "(.gpkg, "
      ".fgb, .geojson, .csv and .wkt keep every bit)",
      changed_, given_.points.size());
}

}  // namespace oblast::io
