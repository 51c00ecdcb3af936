#include "zones/oracles/objects.h"

#include "zones/oracles/frame.h"

namespace zones {

using namespace oblast;

Objects::Objects(const buffers::Shapes& shapes) {
  const auto copy = [&](const std::vector<buffers::Xy>& from, std::vector<Point>& to) {
    for (const auto& p : from) to.push_back({p.x, p.y});
  };
  copy(shapes.region_points, regions_.points);
  copy(shapes.line_points, line_points_);
  copy(shapes.points, points_);
  regions_.contour_ends.assign(shapes.contour_ends.begin(), shapes.contour_ends.end());
  regions_.polygon_ends.assign(shapes.polygon_ends.begin(), shapes.polygon_ends.end());
  line_ends_.assign(shapes.line_ends.begin(), shapes.line_ends.end());
  const FrameBox f(shapes);
  frame_ = {{{f.x0, f.y0}, {f.x1, f.y0}, {f.x1, f.y1}, {f.x0, f.y1}}, {4}, {1}};
}

FeatureSet Objects::zones(double tolerance, ZoneStatistics& statistics) const {
  ZoneOptions options;
  options.tolerance = tolerance;
  options.statistics = &statistics;
  return oblast::zones(view(), frame_, options);
}

}  // namespace zones
