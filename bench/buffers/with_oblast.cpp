// oblast. Mode nearest: the outline is as far from the true one as that of the peers, whose chords are all inside, but
// on both sides of it.
#include <oblast/buffer.h>

#include <cmath>

#include "buffers/shape_file.h"

namespace {

using namespace oblast;

struct Owned {
  std::vector<Point> region_points, line_points, points;
  std::vector<std::uint32_t> contour_ends, polygon_ends, line_ends;

  explicit Owned(const buffers::Shapes& s)
      : region_points(converted(s.region_points)),
        line_points(converted(s.line_points)),
        points(converted(s.points)),
        contour_ends(s.contour_ends.begin(), s.contour_ends.end()),
        polygon_ends(s.polygon_ends.begin(), s.polygon_ends.end()),
        line_ends(s.line_ends.begin(), s.line_ends.end()) {}

  static std::vector<Point> converted(const std::vector<buffers::Xy>& from) {
    std::vector<Point> to;
    to.reserve(from.size());
    for (const auto& [x, y] : from) to.push_back({x, y});
    return to;
  }

  ShapeView view() const { return {{region_points, contour_ends, polygon_ends}, {line_points, line_ends}, points}; }
};

buffers::Shapes written(const RegionSet& zone) {
  buffers::Shapes shapes;
  shapes.region_points.reserve(zone.points.size());
  for (const Point& p : zone.points) shapes.region_points.push_back({p.x, p.y});
  shapes.contour_ends.assign(zone.contour_ends.begin(), zone.contour_ends.end());
  shapes.polygon_ends.assign(zone.polygon_ends.begin(), zone.polygon_ends.end());
  return shapes;
}

}  // namespace

int main(int argc, char** argv) {
  const auto make = [](const buffers::Arguments& arguments) {
    BufferOptions options;
    options.tolerance = 1 - std::cos(3.14159265358979323846 / arguments.segments);
    options.threads = arguments.threads;
    return [shapes = Owned(arguments.shapes), options, &arguments] {
      return buffer(shapes.view(), arguments.distance, options);
    };
  };
  return buffers::drive(argc, argv, make, written);
}
