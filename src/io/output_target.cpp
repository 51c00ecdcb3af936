// Names of outputs, and what is in their files; see output_target.h.
#include "io/output_target.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <memory>
#include <set>

#include "io/formats.h"
#include "io/gdal_session.h"

namespace oblast::io {

namespace fs = std::filesystem;

namespace {

bool equal_names(const std::string& a, const std::string& b) { return EQUAL(a.c_str(), b.c_str()); }

// A shapefile's .shp names the whole set; GDAL gives its files lower-case extensions.
std::string with_own_extension(const std::string& path) {
  return lower_extension(path) == ".shp" ? fs::path(path).replace_extension(".shp").string() : path;
}

}  // namespace

std::string OutputTarget::layer_name() const { return layer.empty() ? fs::path(path).stem().string() : layer; }
bool OutputTarget::is_geopackage() const { return lower_extension(path) == ".gpkg"; }

OutputTarget output_target(const std::string& path) {
  std::error_code error;
  for (std::size_t colon = path.find(':'); colon != std::string::npos; colon = path.find(':', colon + 1)) {
    const OutputTarget target{path.substr(0, colon), path.substr(colon + 1)};
    const Format* format = format_of(target.path);
    // A file may have a colon in its name: a.gpkg:b.gpkg, unless there is a file a.gpkg.
    if (!format || (format_of(path) && !fs::exists(target.path, error))) continue;
    if (!target.is_geopackage())
      throw IoError(
          fmt::format("cannot write {}: only .gpkg files have several layers; leave out :{}", path, target.layer));
    if (target.layer.empty()) throw IoError(fmt::format("cannot write {}: the name of the layer is missing", path));
    return target;
  }
  return {with_own_extension(path), {}};
}

ExistingGeopackage existing_geopackage(const OutputTarget& target) {
  ExistingGeopackage found;
  std::error_code error;
  if (!target.is_geopackage() || !fs::exists(target.path, error)) return found;
  for (const char* journal : {"-wal", "-journal"}) {
    const std::uintmax_t size = fs::file_size(target.path + journal, error);
    if (!error && size > 0)
      throw IoError(
          fmt::format("cannot write {0}: {0}{1} has changes that are not in it yet; close the program that "
                      "has it open, then run the command again",
                      target.path, journal));
  }
  register_gdal_drivers();
  GdalMessages messages;
  const ThreadOption no_listing("GDAL_DISABLE_READDIR_ON_OPEN", "TRUE");
  const char* const drivers[] = {"GPKG", nullptr};
  const char* const all_tables[] = {"LIST_ALL_TABLES=YES", nullptr};
  const std::unique_ptr<GDALDataset> dataset(
      GDALDataset::Open(target.path.c_str(), GDAL_OF_VECTOR | GDAL_OF_RASTER, drivers, all_tables));
  if (!dataset) return found;
  found.readable = true;
  std::set<std::string> names;
  for (OGRLayer* layer : dataset->GetLayers()) names.insert(layer->GetName());
  // Rasters are no layers.
  const char* const sql = "SELECT table_name FROM gpkg_contents";
  const auto release = [&](OGRLayer* rows) { dataset->ReleaseResultSet(rows); };
  const std::unique_ptr<OGRLayer, decltype(release)> contents(dataset->ExecuteSQL(sql, nullptr, nullptr), release);
  while (const std::unique_ptr<OGRFeature> row{contents ? contents->GetNextFeature() : nullptr})
    names.insert(row->GetFieldAsString(0));
  for (const std::string& name : names) {
    if (equal_names(name, target.layer_name())) {
      found.has_layer = true;
    } else {
      found.others.push_back(name);
    }
  }
  return found;
}

void copy_geopackage(const OutputTarget& target, const std::string& stage) {
  std::error_code error;
  fs::copy_file(target.path, stage, error);
  if (error) throw IoError(fmt::format("cannot copy {}: {}", target.path, error.message()));
  fs::permissions(stage, fs::perms::owner_read | fs::perms::owner_write, fs::perm_options::add, error);
}

}  // namespace oblast::io
