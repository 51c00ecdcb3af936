// The geodesic measures are by PROJ: C. F. F. Karney, Algorithms for geodesics, J. Geodesy 87 (2013).
#include "io/row_measures.h"

#include <fmt/format.h>
#include <geodesic.h>
#include <oblast/measure.h>
#include <ogr_spatialref.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/gdal_session.h"

namespace oblast::io {

namespace {

constexpr double pi = 3.14159265358979323846;

// "m" for a unit of a metre; the name in the coordinate system if there is no usual sign.
std::string sign_of(double metres, const char* name) {
  constexpr std::pair<double, const char*> signs[] = {
      {1, "m"}, {0.3048, "ft"}, {1200.0 / 3937, "US survey ft"}, {1000, "km"}};
  for (const auto& [length, sign] : signs)
    if (std::abs(metres / length - 1) < 1e-9) return sign;
  return name ? name : "units";
}

// q of Snyder, Map projections (1987), (3-12): proportional to the area between the equator and a latitude.
double authalic_q(double sine, double e) {
  if (e == 0) return 2 * sine;
  return (1 - e * e) * (sine / (1 - e * e * sine * sine) + std::atanh(e * sine) / e);
}

}  // namespace

RowMeasures::RowMeasures(const std::string& crs_wkt) {
  if (crs_wkt.empty()) return;
  GdalMessages messages;
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.importFromWkt(crs_wkt.c_str()) != OGRERR_NONE) return;
  if (!crs.IsGeographic()) {
    const char* name = nullptr;
    const double metres = crs.GetLinearUnits(&name);
    if (crs.IsProjected()) unit_ = sign_of(metres, name);
    return;
  }
  radius_ = crs.GetSemiMajor();
  const double inverse = crs.GetInvFlattening();
  flattening_ = inverse == 0 ? 0 : 1 / inverse;
  degrees_ = crs.GetAngularUnits() * 180 / pi;
  if (std::abs(degrees_ - 1) < 1e-12) degrees_ = 1;
  const char* angle = nullptr;
  crs.GetAngularUnits(&angle);
  unit_ = degrees_ == 1 ? "degrees" : angle ? angle : "units";
}

std::string RowMeasures::area_unit() const {
  if (geodesic()) return "m2 on the ellipsoid";
  return unit_ == "units" ? "square units of the coordinates" : unit_ + "2";
}
std::string RowMeasures::length_unit() const {
  if (geodesic()) return "m on the ellipsoid";
  return unit_ == "units" ? "units of the coordinates" : unit_;
}

// The area under a great circle is E. Todhunter, Spherical Trigonometry (1886), 103. A contour with an edge of more
// than two kilometres is measured by PROJ.
double RowMeasures::area_of_contour(std::span<const Point> contour) const {
  const double e = std::sqrt(flattening_ * (2 - flattening_)), q_of_pole = authalic_q(1, e);
  const auto half_tangent = [&](const Point& p) {  // of half the authalic latitude
    const double sine = authalic_q(std::sin(p.y * degrees_ * pi / 180), e) / q_of_pole;
    return sine / (1 + std::sqrt(std::max(0.0, 1 - sine * sine)));
  };
  constexpr double short_edge = 0.02;
  double sum = 0;
  const Point* from = &contour.back();
  double below_from = half_tangent(*from);
  for (const Point& to : contour) {
    const double east = (to.x - from->x) * degrees_;
    if (!(std::abs(east) < short_edge) || !(std::abs(to.y - from->y) * degrees_ < short_edge))
      return of_contour(contour).area;
    const double below = half_tangent(to);
    sum -= 2 * std::atan(std::tan(east * pi / 360) * (below_from + below) / (1 + below_from * below));
    below_from = below;
    from = &to;
  }
  return sum * radius_ * radius_ * q_of_pole / 2;
}

std::string RowMeasures::area_text(const RegionView& regions) const {
  if (!geodesic()) return fmt::format("{:.10g} {}", oblast::area(regions), area_unit());
  std::vector<double> areas(regions.contour_count(), 0);
  tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t c) {
    if (!regions.contour(c).empty()) areas[c] = std::abs(area_of_contour(regions.contour(c)));
  });
  // The first contour of a polygon is its outer one. Contours of a repaired layer may run either way.
  double area = 0;
  for (std::size_t p = 0; p < regions.polygon_count(); ++p)
    for (std::size_t c = regions.polygon_begin(p); c < regions.polygon_end(p); ++c)
      area += c == regions.polygon_begin(p) ? areas[c] : -areas[c];
  constexpr double square_kilometre = 1e6;
  if (std::abs(area) < square_kilometre) return fmt::format("{:.6g} {}", area, area_unit());
  const double kilometres = area / square_kilometre;
  return fmt::format("{} km2 on the ellipsoid",
                     kilometres < 1e6 ? fmt::format("{:.6g}", kilometres) : fmt::format("{:.0f}", kilometres));
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
