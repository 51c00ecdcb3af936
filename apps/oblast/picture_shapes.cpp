#include "oblast/picture_shapes.h"

#include <algorithm>

#include "oblast/buffer_plane.h"

namespace oblast::app {

namespace {

void end_polygon(RegionSet& regions) {
  regions.contour_ends.push_back(static_cast<std::uint32_t>(regions.points.size()));
  regions.polygon_ends.push_back(static_cast<std::uint32_t>(regions.contour_ends.size()));
}

}  // namespace

io::Layer drawable(const io::Layer& layer) {
  io::Layer drawn;
  drawn.files = layer.files;
  drawn.crs_wkt = layer.crs_wkt;
  drawn.report = layer.report;
  drawn.regions = layer.regions;
  const io::LinesAndPoints& others = layer.others;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : others.line_ends) {
    const auto first = others.line_vertices.begin() + begin, last = others.line_vertices.begin() + end;
    drawn.regions.points.insert(drawn.regions.points.end(), first, last);
    if (end - begin > 2) std::reverse_copy(first + 1, last - 1, std::back_inserter(drawn.regions.points));
    end_polygon(drawn.regions);
    begin = end;
  }
  const std::optional<Box> box = extent_of(layer);
  if (!box) return drawn;
  constexpr double part_of_picture = 0.002;
  const double half = part_of_picture * std::max(box->x1 - box->x0, box->y1 - box->y0);
  for (const Point& p : others.points) {
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      drawn.regions.points.push_back({p.x + half * x, p.y + half * y});
    end_polygon(drawn.regions);
  }
  return drawn;
}

}  // namespace oblast::app
