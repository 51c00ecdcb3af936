// Poles, date line, swapped axes; see coordinate_scan.h.
#include "io/coordinate_scan.h"

#include <ogr_spatialref.h>

#include <cmath>
#include <numbers>

#include "io/crs_code.h"
#include "io/gdal_session.h"

namespace oblast::io {

CoordinateScan::CoordinateScan(const std::string& crs_wkt) {
  if (crs_wkt.empty()) return;
  GdalMessages messages;
  OGRSpatialReference crs;
  if (!import_crs(crs, crs_wkt) || !crs.IsGeographic()) return;
  const double unit = crs.GetAngularUnits(nullptr);  // radians
  constexpr double near_whole = 1e9;                 // 90 degrees, not 90.00000000000001
  if (unit > 0) quarter_ = std::round(std::numbers::pi / 2 / unit * near_whole) / near_whole;
  double west = 0, south = 0, east = 0, north = 0;
  if (crs.GetAreaOfUse(&west, &south, &east, &north, nullptr) && west < east) {
    area_x_ = {west, east};
    area_y_ = {south, north};
  }
}

// A vertex on either side of the date line, or an edge of more than half a turn. An edge from -180 to 180 goes around
// the world on purpose: that of the Antarctic, or of a frame of the whole world.
void CoordinateScan::scan(std::span<const Point> ring) {
  const double half = 2 * quarter_;
  Range x;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& p = ring[i];
    x.add(p.x);
    y_.add(p.y);
    if (std::abs(p.y) > quarter_) ++beyond_pole_;
    if (i == 0) continue;
    const double before = ring[i - 1].x;
    if (std::abs(p.x - before) > half && !(std::abs(p.x) == half && std::abs(before) == half)) across_now_ = true;
  }
  if ((x.least < half && x.most > half) || (x.least < -half && x.most > -half)) across_now_ = true;
  x_.add(x.least);
  x_.add(x.most);
}

void CoordinateScan::end_polygon() {
  across_ += across_now_;
  across_now_ = false;
}

void CoordinateScan::add(const CoordinateScan& other) {
  for (const double x : {other.x_.least, other.x_.most}) x_.add(x);
  for (const double y : {other.y_.least, other.y_.most}) y_.add(y);
  beyond_pole_ += other.beyond_pole_;
  across_ += other.across_;
}

bool CoordinateScan::looks_swapped() const {
  const auto is_latitude = [&](const Range& range) { return range.least >= -quarter_ && range.most <= quarter_; };
  if (x_.least > x_.most) return false;
  if (!is_latitude(y_)) return is_latitude(x_) && y_.least >= -2 * quarter_ && y_.most <= 2 * quarter_;
  const auto in_area = [&](double x, double y) {
    return area_x_.least <= x && x <= area_x_.most && area_y_.least <= y && y <= area_y_.most;
  };
  if (area_x_.least > area_x_.most) return false;
  return !in_area(x_.middle(), y_.middle()) && in_area(y_.middle(), x_.middle());
}

void CoordinateScan::report_to(ReadReport& report) const {
  report.beyond_pole += beyond_pole_;
  report.across_date_line += across_;
  report.swapped += looks_swapped();
}

}  // namespace oblast::io
