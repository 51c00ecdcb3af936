// oblast: the zones of points in their box. Arguments as in shape_file.h, of which distance and segments are not used.
#include <oblast/zones.h>

#include "zones/cells.h"

namespace {

using namespace oblast;

buffers::Shapes written(const FeatureSet& found) {
  buffers::Shapes cells;
  for (const Point& p : found.regions.points) cells.region_points.push_back({p.x, p.y});
  cells.contour_ends.assign(found.regions.contour_ends.begin(), found.regions.contour_ends.end());
  cells.polygon_ends.assign(found.regions.polygon_ends.begin(), found.regions.polygon_ends.end());
  return cells;
}

}  // namespace

int main(int argc, char** argv) {
  const auto make = [](const buffers::Arguments& arguments) {
    const zones::Frame box(arguments.shapes.points);
    std::vector<Point> points;
    for (const auto& p : arguments.shapes.points) points.push_back({p.x, p.y});
    RegionSet frame{{{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}}, {4}, {1}};
    return [points, frame, threads = arguments.threads] {
      ZoneOptions options;
      options.threads = threads;
      return oblast::zones({{{}, {}, points}, {}, {}, {}}, frame, options);
    };
  };
  return buffers::drive(argc, argv, make, written);
}
