// By PROJ, through GDAL; see point_transform.h.
#include "io/point_transform.h"

#include <ogr_spatialref.h>

#include <limits>
#include <vector>

#include "io/crs.h"
#include "io/crs_code.h"
#include "io/gdal_session.h"
#include "io/layer.h"

namespace oblast::io {

struct PointTransform::Data {
  std::unique_ptr<OGRCoordinateTransformation> transformation;
  std::vector<double> x, y;
  std::vector<int> done;
};

PointTransform::PointTransform(const std::string& from_wkt, const std::string& to_wkt)
    : data_(std::make_unique<Data>()), target_name_(crs_name(to_wkt)) {
  GdalMessages messages;
  OGRSpatialReference from, to;
  if (import_crs(from, from_wkt) && import_crs(to, to_wkt))
    data_->transformation.reset(OGRCreateCoordinateTransformation(&from, &to));
  if (!data_->transformation)
    throw IoError("PROJ cannot transform " + crs_name(from_wkt) + " to " + target_name_ + ": " +
                  messages.text("it gave no reason"));
}

PointTransform::~PointTransform() = default;
PointTransform::PointTransform(PointTransform&&) noexcept = default;
PointTransform& PointTransform::operator=(PointTransform&&) noexcept = default;

void PointTransform::apply(std::span<Point> points) {
  auto& [transformation, x, y, done] = *data_;
  x.clear();
  y.clear();
  for (const Point& p : points) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  done.assign(points.size(), 0);
  const GdalMessages messages;  // PROJ says little; the caller names the vertex
  transformation->Transform(static_cast<int>(points.size()), x.data(), y.data(), nullptr, done.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    constexpr double none = std::numeric_limits<double>::infinity();
    points[i] = done[i] ? Point{x[i], y[i]} : Point{none, none};
  }
}

}  // namespace oblast::io
