// From a layer's or a .prj file's coordinate system to WKT; see crs_reader.h.
#include "io/crs_reader.h"

#include <ogrsf_frmts.h>

#include <map>
#include <mutex>
#include <string_view>

#include "io/formats.h"
#include "io/gdal_session.h"
#include "io/layer.h"
#include "io/paths.h"
#include "io/shapefile_check.h"

namespace oblast::io {

namespace {

std::string wkt_of(const OGRSpatialReference& crs) {
  // A GeoPackage without a coordinate system says so with a system of this name.
  const char* title = crs.GetName();
  if (title && std::string_view(title).starts_with("Undefined ")) return {};
  const char* const wkt2[] = {"FORMAT=WKT2_2019", nullptr};
  char* text = nullptr;
  const OGRErr error = crs.exportToWkt(&text, wkt2);
  const std::string result = error == OGRERR_NONE && text ? text : "";
  CPLFree(text);
  return result;
}

// GDAL compares a .prj with every system of PROJ's database, a tenth of a second for one that is not
// there. The files of a folder mostly share one text, so that is done once a text. (For each layer GDAL still
// parses the .prj, without comparing.)
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
  if (!crs) throw IoError(file + " does not hold a coordinate system that GDAL understands");
  return wkt_of_prj[text] = wkt_of(*crs);
}

}  // namespace

std::string read_crs(OGRLayer& layer, const std::string& path) {
  if (lower_extension(path) == ".shp") return shapefile_crs(layer, path);
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  return crs ? wkt_of(*crs) : "";
}

}  // namespace oblast::io
