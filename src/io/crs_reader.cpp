// Converts the coordinate system of a layer or of a .prj file to WKT; see crs_reader.h.
#include "io/crs_reader.h"

#include <ogrsf_frmts.h>

#include <map>
#include <mutex>
#include <string_view>

#include "io/crs_code.h"
#include "io/formats.h"
#include "io/gdal_session.h"
#include "io/layer.h"
#include "io/paths.h"
#include "io/shapefile_check.h"

namespace oblast::io {

namespace {

std::string wkt_of(const OGRSpatialReference& crs) {
  // A GeoPackage without a coordinate system has a system of this name.
  const char* title = crs.GetName();
  if (title && std::string_view(title).starts_with("Undefined ")) return {};
  return horizontal_wkt(crs);
}

// GDAL compares a .prj with every system in PROJ's database. This takes a tenth of a second if the database does not
// have it. Most files of a folder have the same text, so each text is compared once. (GDAL still parses the .prj of
// each layer, without the comparison.)
std::string shapefile_crs(OGRLayer& layer, const std::string& path) {
  static std::mutex lock;
  static std::map<std::string, std::string> wkt_of_prj;

  const std::string file = find_sibling(path, ".prj");
  const std::string text = file.empty() ? "" : read_text(file);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return {};
  const std::lock_guard hold(lock);
  const auto known = wkt_of_prj.find(text);
  if (known != wkt_of_prj.end()) return known->second;
  const ThreadOption compare("USE_OSR_FIND_MATCHES", "YES");
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  if (!crs)
    throw IoError(file +
                  " has no coordinate system that GDAL understands; correct the file, or remove it to read the "
                  "layer without a coordinate system");
  return wkt_of_prj[text] = wkt_of(*crs);
}

}  // namespace

std::string read_crs(OGRLayer& layer, const std::string& path) {
  if (lower_extension(path) == ".shp") return shapefile_crs(layer, path);
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  return crs ? wkt_of(*crs) : "";
}

}  // namespace oblast::io
