// From SRIDs to coordinate systems; see srid.h.
#include "io/srid.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include "io/crs_code.h"
#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

namespace {

std::string named(unsigned srid) { return srid == 0 ? "no SRID" : fmt::format("SRID={}", srid); }

}  // namespace

bool CommonSrid::add(unsigned srid, const std::string& place) {
  if (srid_) {
    if (srid == *srid_) return false;
    throw IoError(
        fmt::format("{}, {}: {}, but the first geometry has {}; all geometries of one input must be in one "
                    "coordinate system",
                    name_, place, named(srid), named(*srid_)));
  }
  srid_ = srid;
  if (srid == 0) return true;
  GdalMessages messages;
  OGRSpatialReference crs;
  // PostGIS uses the codes of both authorities, which do not overlap.
  for (const char* authority : {"EPSG", "ESRI"}) {
    if (crs.SetFromUserInput(fmt::format("{}:{}", authority, srid).c_str()) != OGRERR_NONE) continue;
    wkt_ = horizontal_wkt(crs);
    return true;
  }
  throw IoError(fmt::format("{}, {}: PROJ knows no coordinate system for {}", name_, place, named(srid)));
}

}  // namespace oblast::io
