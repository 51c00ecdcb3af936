#include "oblast/buffer_plane.h"

#include <fmt/format.h>
#include <oblast/domain.h>
#include <oblast/oblast.h>

#include <algorithm>
#include <cmath>

#include "io/crs.h"
#include "io/point_transform.h"

namespace oblast::app {

namespace {

void extend(std::optional<Box>& box, std::span<const Point> points) {
  for (const Point& p : points) {
    if (!box) box = Box{p.x, p.y, p.x, p.y};
    box = Box{std::min(box->x0, p.x), std::min(box->y0, p.y), std::max(box->x1, p.x), std::max(box->y1, p.y)};
  }
}

std::vector<Point> moved(std::span<const Point> from, io::PointTransform& transform) {
  std::vector<Point> points(from.begin(), from.end());
  transform.apply(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (in_domain(points[i].x) && in_domain(points[i].y)) continue;
    throw io::IoError(fmt::format("the point ({}, {}) cannot be transformed to {}; name a system that fits the layer",
                                  from[i].x, from[i].y, transform.target_name()));
  }
  return points;
}

}  // namespace

std::optional<Box> extent_of(const io::Layer& layer) {
  std::optional<Box> box;
  extend(box, layer.regions.points);
  extend(box, layer.others.line_vertices);
  extend(box, layer.others.points);
  return box;
}

BufferPlane::BufferPlane(const io::Rows& rows, const std::string& crs_wkt) : rows_(rows), wkt_(crs_wkt) {
  const io::Layer& layer = rows.layer;
  region_rows_.reserve(layer.regions.polygon_ends.size());
  for (std::uint32_t row = 0; row < rows.ends.size(); ++row) region_rows_.resize(rows.ends[row], row);
  unit_ = io::coordinate_unit(wkt_.empty() ? layer.crs_wkt : wkt_);
  if (wkt_.empty()) return;
  full_turn_ = io::coordinate_unit(layer.crs_wkt).full_turn;
  if (const std::optional<Box> box = extent_of(layer)) middle_ = (box->x0 + box->x1) / 2;
  io::PointTransform transform(layer.crs_wkt, wkt_);
  moved_ = {moved(layer.regions.points, transform), moved(layer.others.line_vertices, transform),
            moved(layer.others.points, transform)};
}

ShapeFeatures BufferPlane::shapes() const {
  const io::Layer& layer = rows_.layer;
  const io::LinesAndPoints& others = layer.others;
  ShapeFeatures features{{layer.regions, {others.line_vertices, others.line_ends}, others.points},
                         region_rows_,
                         others.line_features,
                         others.point_features};
  if (is_other()) {
    features.shapes.regions.points = moved_.regions;
    features.shapes.lines.points = moved_.lines;
    features.shapes.points = moved_.points;
  }
  return features;
}

// Longitudes come back between -180 and 180. Those of the other side of the date line go on beyond it.
void BufferPlane::move_back(std::vector<Point>& points) const {
  io::PointTransform transform(wkt_, rows_.layer.crs_wkt);
  points = moved(points, transform);
  if (full_turn_ == 0) return;
  for (Point& p : points) p.x -= full_turn_ * std::round((p.x - middle_) / full_turn_);
}

void BufferPlane::check_turns(const RegionView& regions) const {
  if (full_turn_ == 0) return;
  for (std::size_t c = 0; c < regions.contour_count(); ++c) {
    const std::span<const Point> contour = regions.contour(c);
    for (std::size_t i = 0; i < contour.size(); ++i) {
      if (std::abs(contour[i].x - contour[i == 0 ? contour.size() - 1 : i - 1].x) <= full_turn_ / 2) continue;
      throw io::IoError(
          "a zone holds a pole, or goes around the globe, and has no outline in longitudes and latitudes; keep the "
          "result in a projected system with --t_srs, such as EPSG:3995 (Arctic) or EPSG:3031 (Antarctic)");
    }
  }
}

RegionSet BufferPlane::back(RegionSet zone, const CallOptions& options) const {
  if (!is_other()) return zone;
  move_back(zone.points);
  check_turns(zone);
  Options united;
  static_cast<CallOptions&>(united) = options;
  return unite(zone, united);
}

FeatureSet BufferPlane::back(FeatureSet zones, const CallOptions& options) const {
  if (!is_other()) return zones;
  move_back(zones.regions.points);
  check_turns(zones.regions);
  RepairOptions repaired;
  static_cast<CallOptions&>(repaired) = options;
  return repair(zones, repaired).features;
}

// Shared vertices move together, so the rows still cover every place between them an odd number of times: there is
// nothing to close.
FeatureSet BufferPlane::coverage_back(FeatureSet zones, const CallOptions& options) const {
  if (!is_other()) return zones;
  move_back(zones.regions.points);
  check_turns(zones.regions);
  CoverageRepairOptions repaired;
  static_cast<CallOptions&>(repaired) = options;
  return repair_coverage(zones, repaired).features;
}

}  // namespace oblast::app
