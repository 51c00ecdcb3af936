// Comparing coordinate systems; see crs.h.
#include "io/crs.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include "io/crs_code.h"
#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

bool import_crs(OGRSpatialReference& crs, const std::string& wkt) {
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs.importFromWkt(wkt.c_str()) == OGRERR_NONE;
}

std::string horizontal_wkt(const OGRSpatialReference& crs) {
  OGRSpatialReference flat(crs);
  if (flat.IsCompound()) flat.StripVertical();
  if (flat.GetAxesCount() == 3 && (flat.IsGeographic() || flat.IsProjected())) flat.DemoteTo2D(nullptr);
  const char* const wkt2[] = {"FORMAT=WKT2_2019", nullptr};
  char* text = nullptr;
  const OGRErr error = flat.exportToWkt(&text, wkt2);
  std::string result = error == OGRERR_NONE && text ? text : "";
  CPLFree(text);
  return result;
}

std::string crs_from_text(const std::string& text) {
  GdalMessages messages;
  OGRSpatialReference crs;
  const char* const offline[] = {"ALLOW_NETWORK_ACCESS=NO", nullptr};
  if (crs.SetFromUserInput(text.c_str(), offline) != OGRERR_NONE)
    throw IoError(text + " is not a coordinate system that PROJ knows; write a code, such as EPSG:4326");
  return horizontal_wkt(crs);
}

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

namespace {

[[noreturn]] void refuse_one_without(const std::string& with, const std::string& wkt, const std::string& without) {
  throw IoError(
      fmt::format("{} names no coordinate system, but {} is in {}; add --assume-crs {} if the coordinates "
                  "are in that system, or name the right one",
                  without, with, crs_name(wkt), crs_word(wkt)));
}

OGRSpatialReference flat_crs(const std::string& wkt) {
  OGRSpatialReference crs;
  if (import_crs(crs, wkt)) (void)import_crs(crs, horizontal_wkt(crs));
  return crs;
}

}  // namespace

bool same_crs(const std::string& wkt_a, const std::string& wkt_b) {
  if (wkt_a.empty() || wkt_b.empty() || wkt_a == wkt_b) return true;
  GdalMessages messages;
  const OGRSpatialReference a = flat_crs(wkt_a), b = flat_crs(wkt_b);
  if (a.IsEmpty() || b.IsEmpty()) return false;
  const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                 "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", nullptr};
  if (a.IsSame(&b, options)) return true;
  // Projected systems that differ only by the order of axes, or by the names ESRI gives them.
  const std::string code = crs_code(a);
  return !code.empty() && code == crs_code(b);
}

void CommonCrs::add(const std::string& wkt, const std::string& file) {
  if (wkt.empty()) {
    if (file_without_.empty()) file_without_ = file;
    return refuse_mixture();
  }
  if (accepted_.contains(wkt)) return;
  if (wkt_.empty()) {
    wkt_ = wkt;
    file_ = file;
    refuse_mixture();
  } else if (!same_crs(wkt_, wkt)) {
    throw IoError(
        fmt::format("two coordinate systems in one operand: {} has {}, {} has {}; add --t_srs {} to transform "
                    "all files to one of them",
                    file_, crs_name(wkt_), file, crs_name(wkt), crs_word(wkt_)));
  }
  accepted_.insert(wkt);
}

void CommonCrs::refuse_mixture() const {
  if (!wkt_.empty() && !file_without_.empty()) refuse_one_without(file_, wkt_, file_without_);
}

void require_same_crs(const std::string& label_a, const std::string& wkt_a, const std::string& label_b,
                      const std::string& wkt_b) {
  if (wkt_a.empty() && !wkt_b.empty()) refuse_one_without(label_b, wkt_b, label_a);
  if (wkt_b.empty() && !wkt_a.empty()) refuse_one_without(label_a, wkt_a, label_b);
  if (same_crs(wkt_a, wkt_b)) return;
  throw IoError(
      fmt::format("two coordinate systems: {} is in {}, {} is in {}; add --t_srs {} to transform both to one "
                  "of them",
                  label_a, crs_name(wkt_a), label_b, crs_name(wkt_b), crs_word(wkt_a)));
}

std::string crs_name(const std::string& wkt) {
  if (wkt.empty()) return "none";
  GdalMessages messages;
  OGRSpatialReference crs;
  if (!import_crs(crs, wkt)) return "unreadable";
  const char* name = crs.GetName();
  const std::string code = crs_code(crs);
  return (name ? std::string(name) : "unnamed") + (code.empty() ? "" : " (" + code + ")");
}

std::string crs_word(const std::string& wkt) {
  GdalMessages messages;
  OGRSpatialReference crs;
  const std::string code = import_crs(crs, wkt) ? crs_code(crs) : "";
  return code.empty() ? crs_name(wkt) : code;
}

}  // namespace oblast::io
