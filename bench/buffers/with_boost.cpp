// Boost.Geometry. It wants valid multi-polygons, so several polygons are united first (pairwise, in the order of the
// file), and timed.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_linestring.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "buffers/shape_file.h"

namespace {

namespace geometry = boost::geometry;
using BoostPoint = geometry::model::d2::point_xy<double>;
using Polygon = geometry::model::polygon<BoostPoint, false, false>;
using MultiPolygon = geometry::model::multi_polygon<Polygon>;
using MultiLine = geometry::model::multi_linestring<geometry::model::linestring<BoostPoint>>;
using MultiPoint = geometry::model::multi_point<BoostPoint>;

struct Input {
  MultiPolygon regions;
  MultiLine lines;
  MultiPoint points;

  explicit Input(const buffers::Shapes& shapes) {
    std::uint64_t point = 0, contour = 0, line_point = 0;
    for (const std::uint64_t end : shapes.polygon_ends) {
      Polygon& polygon = regions.emplace_back();
      polygon.inners().resize(end - contour - 1);
      for (std::uint64_t c = contour; c < end; ++c) {
        auto& ring = c == contour ? polygon.outer() : polygon.inners()[c - contour - 1];
        for (; point < shapes.contour_ends[c]; ++point)
          ring.push_back({shapes.region_points[point].x, shapes.region_points[point].y});
      }
      contour = end;
      geometry::correct(polygon);
    }
    for (const std::uint64_t end : shapes.line_ends) {
      auto& line = lines.emplace_back();
      for (; line_point < end; ++line_point)
        line.push_back({shapes.line_points[line_point].x, shapes.line_points[line_point].y});
    }
    for (const auto& p : shapes.points) points.push_back({p.x, p.y});
  }
};

MultiPolygon unite(const MultiPolygon& all) {
  std::vector<MultiPolygon> parts;
  for (const Polygon& polygon : all) parts.emplace_back().push_back(polygon);
  while (parts.size() > 1) {
    std::vector<MultiPolygon> next((parts.size() + 1) / 2);
    for (std::size_t i = 0; i < next.size(); ++i) {
      if (2 * i + 1 < parts.size())
        geometry::union_(parts[2 * i], parts[2 * i + 1], next[i]);
      else
        next[i] = std::move(parts[2 * i]);
    }
    parts = std::move(next);
  }
  return parts.empty() ? MultiPolygon() : parts[0];
}

}  // namespace

int main(int argc, char** argv) {
  const auto make = [](const buffers::Arguments& arguments) {
    return [input = Input(arguments.shapes), &arguments] {
      const geometry::strategy::buffer::distance_symmetric<double> distance(arguments.distance);
      const geometry::strategy::buffer::side_straight side;
      const geometry::strategy::buffer::join_round join(static_cast<std::size_t>(arguments.segments));
      const geometry::strategy::buffer::end_round end(static_cast<std::size_t>(arguments.segments));
      const geometry::strategy::buffer::point_circle circle(static_cast<std::size_t>(arguments.segments));
      MultiPolygon zone;
      const auto run = [&](const auto& shapes) { geometry::buffer(shapes, zone, distance, side, join, end, circle); };
      if (!input.points.empty())
        run(input.points);
      else if (!input.lines.empty())
        run(input.lines);
      else
        run(input.regions.size() > 1 ? unite(input.regions) : input.regions);
      return zone;
    };
  };
  const auto write = [](const MultiPolygon& zone) {
    buffers::Shapes shapes;
    const auto ring = [&](const auto& from) {
      std::vector<buffers::Xy> points;
      for (const auto& p : from) points.push_back({p.x(), p.y()});
      shapes.add_ring(points);
    };
    for (const Polygon& polygon : zone) {
      ring(polygon.outer());
      for (const auto& hole : polygon.inners()) ring(hole);
      shapes.end_polygon();
    }
    return shapes;
  };
  return buffers::drive(argc, argv, make, write);
}
