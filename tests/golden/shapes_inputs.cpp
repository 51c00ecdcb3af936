// Hostile cases as layers, and as shapes with zones around them.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "generators/hostile.h"
#include "generators/random.h"
#include "generators/request.h"
#include "golden/inputs.h"
#include "golden/results.h"

namespace oblast::golden {
namespace {

using generators::HostileGenerator, generators::Operands, generators::Random;

constexpr std::uint64_t seeds = 50;  // of each generator
constexpr int most_edges = 40;

/// A as polygons; the contours of B as lines and, of every other one, its vertices as points.
class Shapes {
 public:
  explicit Shapes(Operands operands) : regions_(std::move(operands.a)), lines_(std::move(operands.b.points)) {
    for (const std::uint32_t end : operands.b.contour_ends) ends_.push_back(end);
    for (std::size_t l = 0; l < ends_.size(); l += 2) {
      const auto line = view().lines[l];
      points_.insert(points_.end(), line.begin(), line.end());
    }
  }

  ShapeView view() const { return {regions_, {lines_, ends_}, points_}; }

  /// The larger side of the box of all shapes.
  double extent() const {
    double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;
    for (const auto* points : {&regions_.points, &lines_}) {
      for (const Point& p : *points)
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    return std::max({x1 - x0, y1 - y0, 0x1p-200});
  }

 private:
  RegionSet regions_;
  std::vector<Point> lines_, points_;
  std::vector<std::uint32_t> ends_;
};

/// A power of two from 2^-least to 2^-most.
double drawn_power(Random& random, int least, int most) { return std::ldexp(1.0, -random.between(least, most)); }

InputAndResult drawn_buffer(const HostileGenerator& generator, std::uint64_t seed) {
  Random random(seed ^ 0xb0ffe3u);
  const Shapes shapes(generator.make(seed, random.between(8, most_edges)));
  BufferOptions options;
  options.threads = 1;
  options.join = static_cast<Join>(random.below(3));
  options.cap = static_cast<Cap>(random.below(3));
  options.side = random.one_in(3) ? static_cast<Side>(random.below(3)) : Side::both;
  options.mode = static_cast<BufferMode>(random.below(3));
  options.tolerance = drawn_power(random, 3, 14);
  const double distance = shapes.extent() * drawn_power(random, 2, 9);
  return buffer_zone(shapes.view(), random.one_in(4) ? -distance : distance, options);
}

InputAndResult drawn_zones(const HostileGenerator& generator, std::uint64_t seed) {
  Random random(seed ^ 0x20ae5u);
  const Shapes shapes(generator.make(seed, random.between(8, most_edges)));
  ZoneOptions options;
  options.threads = 1;
  options.relative_tolerance = drawn_power(random, 4, 11);
  if (random.one_in(4)) options.distance = shapes.extent() * drawn_power(random, 1, 6);
  return proximity_zones(shapes.view(), options);
}

InputAndResult drawn_rows(const HostileGenerator& generator, std::uint64_t seed) {
  const Operands operands = generator.make(seed, Random(seed ^ 0x517eu).between(8, most_edges));
  Options options = generators::options_of(generators::draw_request(seed));
  options.threads = 1;
  options.fill_a = options.fill_b = FillRule::polygons();
  return rows(operands.a, operands.b, options);
}

Family of_hostile_cases(const char* name, const char* what,
                        InputAndResult (*compute)(const HostileGenerator&, std::uint64_t)) {
  Family family{name, what, true, {}};
  for (const HostileGenerator& generator : generators::hostile_generators()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      char digits[8];
      std::snprintf(digits, sizeof digits, " %02d", static_cast<int>(seed));
      family.inputs.push_back(
          {generator.name + std::string(digits), [&generator, seed, compute] { return compute(generator, seed); }});
    }
  }
  return family;
}

}  // namespace

Family rows() {
  return of_hostile_cases("rows", "hostile cases as layers: identity, union, dissolve, depth, partition", drawn_rows);
}

Family buffers() {
  return of_hostile_cases("buffers", "buffer zones of hostile cases as shapes, distance and options by the seed",
                          drawn_buffer);
}

Family zones() {
  return of_hostile_cases("zones", "proximity zones of hostile cases as shapes, tolerance by the seed", drawn_zones);
}

}  // namespace oblast::golden
