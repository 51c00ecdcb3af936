// Projections by PROJ, through GDAL; see working_crs.h. The scales are those of J. P. Snyder, Map projections (1987),
// (8-5) for UTM, (24-1) and (24-2) for equal-area, (25-2) for equidistant, on the sphere.
#include "io/working_crs.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/crs.h"
#include "io/crs_code.h"
#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double mean_radius = 6371008.8;  // of the Earth in metres

/// Longitude and latitude in degrees.
struct Place {
  double longitude, latitude;
};

// In radians.
double angle_between(const Place& a, const Place& b) {
  const double south_north = std::sin((b.latitude - a.latitude) * degree / 2);
  const double west_east = std::sin((b.longitude - a.longitude) * degree / 2);
  const double h =
      south_north * south_north + std::cos(a.latitude * degree) * std::cos(b.latitude * degree) * west_east * west_east;
  return 2 * std::asin(std::min(1.0, std::sqrt(h)));
}

// A layer all around a pole has its middle there.
Place middle_of(const Box& degrees) {
  const double longitude = (degrees.x0 + degrees.x1) / 2;
  if (degrees.x1 - degrees.x0 > 180) {
    if (degrees.y0 > 0) return {longitude, 90};
    if (degrees.y1 < 0) return {longitude, -90};
  }
  return {longitude, (degrees.y0 + degrees.y1) / 2};
}

double radius_of(const Box& degrees, const Place& middle) {
  double radius = 0;
  for (const double x : {degrees.x0, middle.longitude, degrees.x1})
    for (const double y : {degrees.y0, middle.latitude, degrees.y1})
      radius = std::max(radius, angle_between(middle, {x, y}));
  return radius;
}

double latitude_of_equator_side(const Box& degrees, double reach) {
  if (degrees.y0 - reach <= 0 && degrees.y1 + reach >= 0) return 0;
  return std::min(std::abs(degrees.y0 - reach), std::abs(degrees.y1 + reach));
}

// The zone of the middle, if the layer with its surroundings is hardly wider than a zone.
bool set_utm(OGRSpatialReference& crs, const Box& degrees, double reach, WorkingCrs& working) {
  constexpr double zone_width = 6, south_end = -80, north_end = 84;
  const double reach_north = reach / degree;
  if (crs.GetPrimeMeridian() != 0 || degrees.y0 - reach_north < south_end || degrees.y1 + reach_north > north_end)
    return false;
  const double steepest = std::max(std::abs(degrees.y0 - reach_north), std::abs(degrees.y1 + reach_north));
  const double reach_east = reach_north / std::cos(steepest * degree);
  const Place middle = middle_of(degrees);
  if (degrees.x1 - degrees.x0 + 2 * reach_east > zone_width || std::abs(middle.longitude) > 180) return false;
  const int zone = std::clamp(static_cast<int>(std::floor((middle.longitude + 180) / zone_width)) + 1, 1, 60);
  const bool north = middle.latitude >= 0;
  crs.SetProjCS(fmt::format("{} / UTM zone {}{}", crs.GetName(), zone, north ? 'N' : 'S').c_str());
  crs.SetUTM(zone, north);
  constexpr double scale_of_middle = 0.9996;
  const double meridian = zone_width * zone - 183;
  const double east = std::max(std::abs(degrees.x0 - meridian), std::abs(degrees.x1 - meridian)) + reach_east;
  const double b = east * degree * std::cos(latitude_of_equator_side(degrees, reach_north) * degree);
  working.scale_error = std::max(1 - scale_of_middle, std::abs(scale_of_middle * (1 + b * b / 2) - 1));
  return true;
}

void set_azimuthal(OGRSpatialReference& crs, const Place& middle, double radius, double reach, WorkingCrs& working) {
  constexpr double small = 0.1;
  const double farthest = radius + reach;
  const auto name = [&](const char* projection) {
    return fmt::format("{} / {} around {:.4g}, {:.4g}", crs.GetName(), projection, middle.longitude, middle.latitude);
  };
  if (radius < small * reach) {
    crs.SetProjCS(name("azimuthal equidistant").c_str());
    crs.SetAE(middle.latitude, middle.longitude, 0, 0);
    working.scale_error = (farthest / std::sin(farthest) - 1) * std::sin(radius) / std::sin(farthest);
  } else {
    crs.SetProjCS(name("Lambert azimuthal equal-area").c_str());
    crs.SetLAEA(middle.latitude, middle.longitude, 0, 0);
    working.scale_error = 1 / std::cos(farthest / 2) - 1;
  }
}

}  // namespace

CoordinateUnit coordinate_unit(const std::string& wkt) {
  GdalMessages messages;
  OGRSpatialReference crs;
  if (wkt.empty() || !import_crs(crs, wkt)) return {};
  if (crs.IsGeographic()) {
    constexpr double near_whole = 1e9;  // 360, not 360.00000000000006
    const double turn = 2 * std::numbers::pi / crs.GetAngularUnits();
    return {true, 0, std::round(turn * near_whole) / near_whole};
  }
  return {false, crs.IsProjected() ? crs.GetLinearUnits() : 0, 0};
}

WorkingCrs suitable_crs(const std::string& geographic_wkt, const Box& extent, double reach_metres) {
  GdalMessages messages;
  OGRSpatialReference geographic, crs;
  import_crs(geographic, geographic_wkt);
  crs.CopyGeogCSFrom(&geographic);
  const double unit = geographic.GetAngularUnits() / degree;
  const Box degrees{extent.x0 * unit, extent.y0 * unit, extent.x1 * unit, extent.y1 * unit};
  const double reach = reach_metres / mean_radius;
  WorkingCrs working;
  if (!set_utm(crs, degrees, reach, working)) {
    const Place middle = middle_of(degrees);
    const double radius = radius_of(degrees, middle);
    if (radius + reach > 90 * degree)
      throw IoError(
          "the layer and the distance span more than half of the globe, for which no projection is suitable; use a "
          "part of the layer (--where), or name a system with --crs EPSG:N");
    set_azimuthal(crs, middle, radius, reach, working);
  }
  crs.SetLinearUnits(SRS_UL_METER, 1);
  working.wkt = horizontal_wkt(crs);
  return working;
}

}  // namespace oblast::io
