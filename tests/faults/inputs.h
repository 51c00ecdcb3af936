// Inputs that reach all loops: many parts, one large part, identical edges, traces.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "generators/hostile.h"
#include "generators/random.h"
#include "support/sanitizers.h"

namespace oblast::testing {

struct NamedOperands {
  std::string name;
  generators::Operands operands;
};

/// Clusters of overlapping squares, half of each cluster in A. With more than 4,000 vertices there are many batches of
/// parts.
inline generators::Operands clusters(int count) {
  generators::Random random(7);
  generators::Operands operands;
  for (int c = 0; c < count; ++c) {
    const double cx = random.in(0, 300), cy = random.in(0, 300);
    const int squares = 1 + static_cast<int>(std::exp(random.in(0, 4)));
    for (int i = 0; i < squares; ++i) {
      RegionSet& to = i % 2 == 0 ? operands.a : operands.b;
      const double angle = random.in(0, 6.28), r = random.in(0.05, 0.15);
      const double x = cx + random.in(0, 0.5), y = cy + random.in(0, 0.5);
      for (int k = 0; k < 4; ++k)
        to.points.push_back({x + r * std::cos(angle + k * 1.5708), y + r * std::sin(angle + k * 1.5708)});
      to.contour_ends.push_back(static_cast<std::uint32_t>(to.points.size()));
      to.polygon_ends.push_back(static_cast<std::uint32_t>(to.contour_ends.size()));
    }
  }
  return operands;
}

/// Two polygons with this many vertices each, which meet often: one part.
inline generators::Operands two_stars(int vertices) {
  generators::Operands operands;
  for (int s = 0; s < 2; ++s) {
    RegionSet& star = s == 0 ? operands.a : operands.b;
    for (int i = 0; i < vertices; ++i) {
      const double angle = 6.283185307179586 * (i + 0.3 * s) / vertices, r = i % 2 == 0 ? 1 : 0.8 + 0.05 * s;
      star.points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    star.contour_ends = {static_cast<std::uint32_t>(vertices)};
    star.polygon_ends = {1};
  }
  return operands;
}

/// Slanted lines, clipped by two tiles that share an edge. The shared edge consists of traces.
inline generators::Operands hatch(int lines) {
  generators::Operands operands;
  for (int i = 0; i < lines; ++i) {
    const double y = 2.0 * i / lines;
    for (const Point& p : {Point{-0.1, y}, Point{2.1, y + 0.037}, Point{2.1, y + 0.0375}, Point{-0.1, y + 0.0005}})
      operands.a.points.push_back(p);
    operands.a.contour_ends.push_back(static_cast<std::uint32_t>(operands.a.points.size()));
    operands.a.polygon_ends.push_back(static_cast<std::uint32_t>(operands.a.contour_ends.size()));
  }
  operands.b.points = {{0, 0}, {1, 0}, {1.1, 2}, {0, 2}, {1, 0}, {2, 0}, {2, 2}, {1.1, 2}};
  operands.b.contour_ends = {4, 8};
  operands.b.polygon_ends = {1, 2};
  return operands;
}

/// `scale` 1 is above every threshold. A tenth is enough with a sanitizer.
inline std::vector<NamedOperands> threshold_inputs(double scale) {
  const auto sized = [scale](int size) { return std::max(10, static_cast<int>(size * scale)); };
  return {{"clusters", clusters(sized(400))},
          {"stars", two_stars(sized(40000))},
          {"coverages", generators::coverages(2, sized(40000))},
          {"hatch", hatch(sized(2000))},
          {"copies", generators::copies_of_one_square(3, sized(20000))},
          {"nested", generators::nested_squares(3, sized(20000))}};
}

inline constexpr double usual_scale = under_sanitizer ? 0.1 : 1;

}  // namespace oblast::testing
