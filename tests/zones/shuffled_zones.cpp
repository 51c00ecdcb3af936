#include "zones/shuffled_zones.h"

#include <algorithm>
#include <numeric>

#include "generators/company.h"
#include "generators/random.h"
#include "generators/trial.h"

namespace oblast::testing {
namespace {

using generators::Random;

std::vector<std::size_t> order_of(std::size_t count, bool is_free, Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = 1; is_free && k < count; ++k)
    std::swap(order[k], order[static_cast<std::size_t>(random.below(static_cast<int>(k) + 1))]);
  return order;
}

}  // namespace

ZoneQuestion shuffled(const ZoneQuestion& question, std::uint64_t seed) {
  Random random(seed ^ 0x73687566);
  const ShapeFeatures objects = question.view();
  const ShapeView& shapes = objects.shapes;
  const bool is_free = !question.region_rows.empty() || !question.line_rows.empty() || !question.point_rows.empty();
  ZoneQuestion other;
  other.options = question.options;
  other.frame = generators::shuffled(question.frame, FillRule::polygons(), seed);
  for (const std::size_t p : order_of(shapes.regions.polygon_count(), is_free, random)) {
    RegionSet polygon;
    generators::append_polygon(polygon, shapes.regions, p);
    generators::append(other.regions, generators::shuffled(polygon, FillRule::polygons(), seed + p));
    if (is_free) other.region_rows.push_back(objects.region_rows[p]);
  }
  for (const std::size_t l : order_of(shapes.lines.size(), is_free, random)) {
    std::vector<Point> line(shapes.lines[l].begin(), shapes.lines[l].end());
    if (random.one_in(2)) std::reverse(line.begin(), line.end());
    other.add_line(line);
    if (is_free) other.line_rows.push_back(objects.line_rows[l]);
  }
  for (const std::size_t i : order_of(shapes.points.size(), is_free, random)) {
    other.points.push_back(shapes.points[i]);
    if (is_free) other.point_rows.push_back(objects.point_rows[i]);
  }
  return other;
}

}  // namespace oblast::testing
