// Comparing coordinate systems; see crs.h.
#include "io/crs.h"

#include <ogr_spatialref.h>

#include "io/crs_code.h"
#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

namespace {

bool import(OGRSpatialReference& crs, const std::string& wkt) {
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs.importFromWkt(wkt.c_str()) == OGRERR_NONE;
}

}  // namespace

std::string crs_code(const OGRSpatialReference& crs) {
  const char* authority = crs.GetAuthorityName(nullptr);
  const char* code = crs.GetAuthorityCode(nullptr);
  if (authority && code) return std::string(authority) + ":" + code;

  // An ESRI .prj carries no code: ask PROJ's database, and believe it only when it is nearly sure.
  constexpr int sure_percent = 90;
  int count = 0;
  int* confidence = nullptr;
  OGRSpatialReferenceH* matches = OSRFindMatches(OGRSpatialReference::ToHandle(const_cast<OGRSpatialReference*>(&crs)),
                                                 nullptr, &count, &confidence);
  std::string found;
  if (count > 0 && confidence[0] >= sure_percent) {
    const auto* best = OGRSpatialReference::FromHandle(matches[0]);
    authority = best->GetAuthorityName(nullptr);
    code = best->GetAuthorityCode(nullptr);
    if (authority && code) found = std::string(authority) + ":" + code;
  }
  OSRFreeSRSArray(matches);
  CPLFree(confidence);
  return found;
}

bool same_crs(const std::string& wkt_a, const std::string& wkt_b) {
  if (wkt_a.empty() || wkt_b.empty() || wkt_a == wkt_b) return true;
  GdalMessages messages;
  OGRSpatialReference a, b;
  if (!import(a, wkt_a) || !import(b, wkt_b)) return false;
  const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                 "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", nullptr};
  if (a.IsSame(&b, options)) return true;
  // Projected systems that differ only by the order of axes, or by the names ESRI gives them.
  const std::string code = crs_code(a);
  return !code.empty() && code == crs_code(b);
}

void CommonCrs::add(const std::string& wkt, const std::string& file) {
  if (wkt.empty() || accepted_.contains(wkt)) return;
  if (wkt_.empty()) {
    wkt_ = wkt;
    file_ = file;
  } else if (!same_crs(wkt_, wkt)) {
    throw IoError("two coordinate systems in one operand: " + file_ + " has " + crs_name(wkt_) + ", " + file + " has " +
                  crs_name(wkt));
  }
  accepted_.insert(wkt);
}

std::string crs_name(const std::string& wkt) {
  if (wkt.empty()) return "none";
  GdalMessages messages;
  OGRSpatialReference crs;
  if (!import(crs, wkt)) return "unreadable";
  const char* name = crs.GetName();
  const std::string code = crs_code(crs);
  return (name ? std::string(name) : "unnamed") + (code.empty() ? "" : " (" + code + ")");
}

}  // namespace oblast::io
