#include "zones/objects.h"

#include <oblast/domain.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/index.h"
#include "plane/largest_ulp.h"

namespace oblast::internal::zoning {
namespace {

Array<std::uint32_t> rows_of(std::span<const std::uint32_t> rows, std::size_t count, std::size_t first,
                             const char* what) {
  if (!rows.empty() && rows.size() != count)
    throw Error(ErrorCode::bad_option, "there are " + std::to_string(rows.size()) + " row numbers for " +
                                           std::to_string(count) + ' ' + what + "; it must be one for each");
  Array<std::uint32_t> of(count);
  if (rows.empty())
    std::iota(of.begin(), of.end(), static_cast<std::uint32_t>(first));
  else
    std::copy(rows.begin(), rows.end(), of.begin());
  return of;
}

struct Extent {
  double min_x = HUGE_VAL, min_y = HUGE_VAL, max_x = -HUGE_VAL, max_y = -HUGE_VAL;

  void add(std::span<const Point> points) {
    for (const Point& p : points) {
      min_x = std::min(min_x, p.x);
      max_x = std::max(max_x, p.x);
      min_y = std::min(min_y, p.y);
      max_y = std::max(max_y, p.y);
    }
  }
  double side() const { return std::max(max_x - min_x, max_y - min_y); }
  double largest() const { return std::max({std::fabs(min_x), std::fabs(max_x), std::fabs(min_y), std::fabs(max_y)}); }
};

[[noreturn]] void refuse_room() {
  throw Error(ErrorCode::bad_option,
              "the objects and the frame, widened by eight times their extent, do not fit the domain of coordinates");
}

/// The margin of a frame that the caller leaves to us.
double margin(const Extent& objects, double distance) {
  const double side = objects.side();
  // Of a single place: a margin that its coordinates can tell.
  const double usual = side > 0 ? side / 10 : std::max(1.0, std::ldexp(objects.largest(), -20));
  return std::isfinite(distance) ? std::max(1.5 * distance, std::ldexp(objects.largest(), -40)) : usual;
}

}  // namespace

Objects read_objects(const ShapeFeatures& features) {
  Objects objects;
  objects.shapes = features.shapes;
  const std::size_t polygons = features.shapes.regions.polygon_count(), lines = features.shapes.lines.size(),
                    points = features.shapes.points.size();
  check_count(polygons + lines + points, "shapes in one call", most_indices / 4);
  objects.of_polygon = rows_of(features.region_rows, polygons, 0, "polygons");
  objects.of_line = rows_of(features.line_rows, lines, polygons, "lines");
  objects.of_point = rows_of(features.point_rows, points, polygons + lines, "points");
  std::size_t count = 0;
  for (const auto* rows : {&objects.of_polygon, &objects.of_line, &objects.of_point})
    for (const std::uint32_t row : *rows) count = std::max(count, std::size_t{row} + 1);
  // A row number is an index of the result; two more are needed inside.
  objects.count = checked_index(count, "objects (the largest row number and one)", most_indices / 4);
  return objects;
}

double in_domain_near(double x) { return std::fabs(x) < domain_smallest ? 0 : x + 0.0; }

Room make_room(const ShapeView& shapes, const RegionView& frame, const ZoneOptions& options) {
  Extent objects;
  for (const auto points : {shapes.regions.points, shapes.lines.points, shapes.points}) objects.add(points);
  Room room;
  Extent all = objects;
  const auto point = [](double x, double y) { return Point{in_domain_near(x), in_domain_near(y)}; };
  if (frame.contour_count() == 0) {
    const double m = margin(objects, options.distance);
    room.box_frame = {point(objects.min_x - m, objects.min_y - m), point(objects.max_x + m, objects.min_y - m),
                      point(objects.max_x + m, objects.max_y + m), point(objects.min_x - m, objects.max_y + m)};
    all.add(room.box_frame);
  } else {
    all.add(frame.points);
  }
  const double width = all.max_x - all.min_x, height = all.max_y - all.min_y;
  double diagonal = std::sqrt(width * width + height * height);
  if (diagonal == 0) diagonal = std::max(1.0, all.largest());
  // 2 and 2.12 diagonals away: no place within `all` is as near to them as to any object. Each place further than 1.6
  // diagonals is nearer to one of the eight than to any object.
  const double x = all.min_x / 2 + all.max_x / 2, y = all.min_y / 2 + all.max_y / 2;
  const double far = 2 * diagonal, both = 1.5 * diagonal;
  room.ring = {point(x + far, y), point(x + both, y + both), point(x, y + far), point(x - both, y + both),
               point(x - far, y), point(x - both, y - both), point(x, y - far), point(x + both, y - both)};
  const double largest = largest_coordinate(room.ring);
  if (!(largest <= domain_largest)) refuse_room();
  room.unit = ulp_of(largest);
  const double wanted =
      options.tolerance > 0 ? options.tolerance : options.relative_tolerance * std::max(objects.side(), 0.0);
  room.tolerance = std::max(wanted, 96 * room.unit);
  room.flattening = room.tolerance / 3;
  room.sampling = room.tolerance - 2 * room.flattening;
  return room;
}

}  // namespace oblast::internal::zoning
