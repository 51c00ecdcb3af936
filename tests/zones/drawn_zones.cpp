// Questions about zones drawn from hostile operands.
#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

#include "generators/company.h"
#include "generators/random.h"
#include "zones/zone_trial.h"

namespace oblast::testing {
namespace {

using generators::Random;

generators::Box box_of(const ZoneQuestion& question) {
  generators::Box box;
  for (const auto* points : {&question.regions.points, &question.line_points, &question.points})
    for (const Point& p : *points) box.add(p);
  return box;
}

void add_outlines(ZoneQuestion& question, const RegionView& regions, Random& random) {
  for (const std::span<const Point> contour : regions.contours()) {
    std::vector<Point> line(contour.begin(), contour.end());
    if (!line.empty() && !random.one_in(4)) line.push_back(line.front());
    question.add_line(line);
  }
}

void add_vertices(ZoneQuestion& question, const RegionView& regions, int one_in, Random& random) {
  for (const Point& p : regions.points)
    if (random.one_in(one_in)) question.points.push_back(p);
}

void draw_objects(ZoneQuestion& question, const generators::Operands& operands, Random& random) {
  switch (random.below(5)) {
    case 0:
      question.regions = operands.a;
      if (random.one_in(2)) generators::append(question.regions, operands.b);
      break;
    case 1:
      add_outlines(question, operands.a, random);
      if (random.one_in(2)) add_outlines(question, operands.b, random);
      break;
    case 2:
      add_vertices(question, operands.a, 1, random);
      if (random.one_in(2)) add_vertices(question, operands.b, 1, random);
      break;
    default:
      question.regions = operands.a;
      add_outlines(question, operands.b, random);
      add_vertices(question, operands.b, 4, random);
      if (random.one_in(4)) add_vertices(question, operands.a, 4, random);
  }
}

/// Rows for all shapes: several may be one object, and some objects may have no shape.
void draw_rows(ZoneQuestion& question, Random& random) {
  const auto draw = [&](std::vector<std::uint32_t>& rows, std::size_t shapes, int objects) {
    for (std::size_t k = 0; k < shapes; ++k) rows.push_back(static_cast<std::uint32_t>(random.below(objects)));
  };
  const std::size_t shapes = question.object_count();
  const int objects = 1 + random.below(static_cast<int>(shapes) + 2);
  const std::size_t polygons = question.regions.view().polygon_count();
  draw(question.region_rows, polygons, objects);
  draw(question.line_rows, question.line_ends.size(), objects);
  draw(question.point_rows, question.points.size(), objects);
}

RegionSet draw_frame(const generators::Operands& operands, const generators::Box& box, double extent, Random& random) {
  if (random.one_in(2) || box.empty()) return {};
  if (random.one_in(3)) return operands.b;
  const auto between = [&](double low, double high) {
    const double a = random.in(low - extent, high + extent), b = random.in(low - extent, high + extent);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  auto [x0, x1] = between(box.x0, box.x1);
  auto [y0, y1] = between(box.y0, box.y1);
  if (random.one_in(3)) x0 = box.x0, x1 = box.x1, y0 = box.y0, y1 = box.y1;
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {4}, {1}};
}

}  // namespace

ZoneQuestion draw_zones(const generators::Operands& operands, std::uint64_t seed) {
  Random random(seed ^ 0x7a6f6e6573);
  ZoneQuestion question;
  draw_objects(question, operands, random);
  if (random.one_in(3) && question.object_count() > 0) draw_rows(question, random);
  const generators::Box box = box_of(question);
  const double extent = box.empty() ? 1 : std::max({box.x1 - box.x0, box.y1 - box.y0, 0x1p-200});
  question.frame = draw_frame(operands, box, extent, random);
  ZoneOptions& options = question.options;
  options.threads = 1;
  // Sites grow with the inverse root of the tolerance, and the judge takes its time; points need none.
  const double finest = question.has_points_only() ? -9 : random.one_in(200) ? -6 : -3.5;
  const double relative = std::pow(10, random.in(finest, -1));
  options.relative_tolerance = relative;
  if (random.one_in(3)) options.tolerance = extent * relative;
  if (random.one_in(4)) options.distance = extent * std::pow(10, random.in(-2, 0.5));
  return question;
}

}  // namespace oblast::testing
