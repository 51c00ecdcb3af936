// The geodesic measures are by PROJ: C. F. F. Karney, Algorithms for geodesics, J. Geodesy 87 (2013).
#include "io/row_measures.h"

#include <geodesic.h>
#include <ogr_spatialref.h>

#include <cmath>

#include "io/gdal_session.h"

namespace oblast::io {

RowMeasures::RowMeasures(const std::string& crs_wkt) {
  if (crs_wkt.empty()) return;
  GdalMessages messages;
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.importFromWkt(crs_wkt.c_str()) != OGRERR_NONE) return;
  if (!crs.IsGeographic()) {
    const char* unit = nullptr;
    crs.GetLinearUnits(&unit);
    if (unit && crs.IsProjected()) unit_ = unit;
    return;
  }
  constexpr double degrees_of_a_radian = 180 / 3.14159265358979323846;
  radius_ = crs.GetSemiMajor();
  const double inverse = crs.GetInvFlattening();
  flattening_ = inverse == 0 ? 0 : 1 / inverse;
  degrees_ = crs.GetAngularUnits() * degrees_of_a_radian;
  if (std::abs(degrees_ - 1) < 1e-12) degrees_ = 1;
}

std::string RowMeasures::area_unit() const {
  if (geodesic()) return "square metres on the ellipsoid";
  return "squared units of the coordinates" + (unit_.empty() ? "" : " (" + unit_ + ")");
}
std::string RowMeasures::length_unit() const {
  if (geodesic()) return "metres on the ellipsoid";
  return "units of the coordinates" + (unit_.empty() ? "" : " (" + unit_ + ")");
}

RowMeasures::Measure RowMeasures::of_contour(std::span<const Point> contour) const {
  if (geodesic()) {
    geod_geodesic ellipsoid;
    geod_init(&ellipsoid, radius_, flattening_);
    geod_polygon polygon;
    geod_polygon_init(&polygon, 0);
    for (const Point& p : contour) geod_polygon_addpoint(&ellipsoid, &polygon, p.y * degrees_, p.x * degrees_);
    Measure measure;
    constexpr int counterclockwise = 0, with_sign = 1;
    geod_polygon_compute(&ellipsoid, &polygon, counterclockwise, with_sign, &measure.area, &measure.perimeter);
    return measure;
  }
  const auto size = static_cast<std::uint32_t>(contour.size());
  const std::uint32_t contour_end[] = {size}, polygon_end[] = {1};
  Measure measure{signed_area(RegionView{contour, contour_end, polygon_end}), 0};
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Point& p = contour[i];
    const Point& q = contour[i + 1 < contour.size() ? i + 1 : 0];
    measure.perimeter += std::hypot(q.x - p.x, q.y - p.y);
  }
  return measure;
}

template <class Part>
std::vector<double> RowMeasures::sums(const FeatureView& rows, Part part) const {
  std::vector<double> sums(rows.feature_count(), 0);
  for (std::size_t row = 0; row < sums.size(); ++row) {
    for (std::size_t p = rows.feature_begin(row); p < rows.feature_end(row); ++p) {
      for (std::size_t c = rows.regions.polygon_begin(p); c < rows.regions.polygon_end(p); ++c)
        sums[row] += part(of_contour(rows.regions.contour(c)));
    }
  }
  return sums;
}

std::vector<double> RowMeasures::areas(const FeatureView& rows) const {
  return sums(rows, [](const Measure& measure) { return measure.area; });
}
std::vector<double> RowMeasures::perimeters(const FeatureView& rows) const {
  return sums(rows, [](const Measure& measure) { return measure.perimeter; });
}

}  // namespace oblast::io
