// Clipper2, with 64-bit integers: coordinates are scaled by a power of two, so the largest has 44 bits (not timed). An
// offset unites the zones of positive distances. For negative ones it needs input that does not overlap, so the union
// is made first, and timed.
#include <clipper2/clipper.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "buffers/shape_file.h"

namespace {

namespace clipper = Clipper2Lib;

double largest(const buffers::Shapes& shapes) {
  double most = 0;
  for (const auto* points : {&shapes.region_points, &shapes.line_points, &shapes.points})
    for (const auto& p : *points) most = std::max({most, std::abs(p.x), std::abs(p.y)});
  return most;
}

struct Input {
  double scale;
  clipper::Paths64 regions, lines, points;

  explicit Input(const buffers::Shapes& shapes) : scale(std::exp2(43 - std::ceil(std::log2(largest(shapes))))) {
    cut(shapes.region_points, shapes.contour_ends, regions);
    cut(shapes.line_points, shapes.line_ends, lines);
    for (const auto& p : shapes.points) points.push_back({scaled(p)});
  }

  clipper::Point64 scaled(const buffers::Xy& p) const {
    return {static_cast<std::int64_t>(std::llround(p.x * scale)), static_cast<std::int64_t>(std::llround(p.y * scale))};
  }
  void cut(const std::vector<buffers::Xy>& points, const std::vector<std::uint64_t>& ends,
           clipper::Paths64& paths) const {
    std::uint64_t begin = 0;
    for (const std::uint64_t end : ends) {
      clipper::Path64& path = paths.emplace_back();
      for (; begin < end; ++begin) path.push_back(scaled(points[begin]));
    }
  }
};

struct Zone {
  double scale = 1;
  clipper::PolyTree64 tree;
};

void add(const clipper::PolyPath64& outer, double scale, buffers::Shapes& shapes) {
  const auto ring = [&](const clipper::Path64& path) {
    std::vector<buffers::Xy> points;
    points.reserve(path.size());
    for (const auto& p : path) points.push_back({static_cast<double>(p.x) / scale, static_cast<double>(p.y) / scale});
    shapes.add_ring(points);
  };
  ring(outer.Polygon());
  for (const auto& hole : outer) ring(hole->Polygon());
  shapes.end_polygon();
  for (const auto& hole : outer)
    for (const auto& inner : *hole) add(*inner, scale, shapes);
}

}  // namespace

int main(int argc, char** argv) {
  const auto make = [](const buffers::Arguments& arguments) {
    return [input = Input(arguments.shapes), &arguments] {
      const double delta = arguments.distance * input.scale;
      const double off = 1 - std::cos(3.14159265358979323846 / arguments.segments);
      clipper::ClipperOffset engine(2, std::abs(delta) * off);
      const clipper::Paths64 united =
          delta < 0 ? clipper::Union(input.regions, clipper::FillRule::NonZero) : clipper::Paths64();
      engine.AddPaths(delta < 0 ? united : input.regions, clipper::JoinType::Round, clipper::EndType::Polygon);
      engine.AddPaths(input.lines, clipper::JoinType::Round, clipper::EndType::Round);
      engine.AddPaths(input.points, clipper::JoinType::Round, clipper::EndType::Round);
      auto zone = std::make_unique<Zone>();
      zone->scale = input.scale;
      engine.Execute(delta, zone->tree);
      return zone;
    };
  };
  const auto write = [](const std::unique_ptr<Zone>& zone) {
    buffers::Shapes shapes;
    for (const auto& outer : zone->tree) add(*outer, zone->scale, shapes);
    return shapes;
  };
  return buffers::drive(argc, argv, make, write);
}
