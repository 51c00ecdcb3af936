// Areas and perimeters of rows: in the plane, or on the ellipsoid if coordinates are longitude and latitude.
#pragma once

#include <oblast/features.h>

#include <string>
#include <vector>

namespace oblast::io {

class RowMeasures {
 public:
  /// A geographic coordinate system makes the measures geodesic: the sides of polygons are geodesics of its ellipsoid,
  /// and units are metres. Otherwise units are those of the coordinates.
  explicit RowMeasures(const std::string& crs_wkt);

  bool geodesic() const { return radius_ > 0; }
  /// "m2 on the ellipsoid", "ft2", "square units of the coordinates".
  std::string area_unit() const;
  /// "m on the ellipsoid", "ft", "units of the coordinates".
  std::string length_unit() const;
  /// The unit of the coordinates: "degrees", "m", "ft", "units".
  const std::string& coordinate_unit() const { return unit_; }

  /// The area of all regions together, with its unit, for a reader: "1,234 km2 on the ellipsoid". Six digits hold on
  /// the ellipsoid: short edges are taken as great circles of the sphere of the same area, which is fast. REQUIRES
  /// directions as `areas`.
  std::string area_text(const RegionView& regions) const;

  /// By row. REQUIRES: contours have the directions of a result: outer ones counter-clockwise, holes clockwise.
  std::vector<double> areas(const FeatureView& rows) const;
  std::vector<double> perimeters(const FeatureView& rows) const;

 private:
  struct Measure {
    double area, perimeter;
  };
  Measure of_contour(std::span<const Point> contour) const;
  double area_of_contour(std::span<const Point> contour) const;
  template <class Part>
  std::vector<double> sums(const FeatureView& rows, Part part) const;

  double radius_ = 0;  // the larger one, in metres; 0: plane
  double flattening_ = 0;
  double degrees_ = 1;  // of a unit of the coordinates
  std::string unit_ = "units";
};

}  // namespace oblast::io
