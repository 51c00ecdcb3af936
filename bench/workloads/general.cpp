// Generated workloads, one for each kind of input that the library should be quick on.
#include <array>
#include <cmath>
#include <numbers>

#include "workloads/workloads.h"

namespace oblast::bench {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

Workload stars(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  RegionSet a, b;
  add_polygon(a, wiggly_star(n, 0, random));
  add_polygon(b, wiggly_star(n, 0.3, random));
  return single(Operation::intersection, std::move(a), std::move(b));
}

// n parallel bars, turned so that no edge is parallel to an axis.
RegionSet bars(std::uint32_t n, double turn) {
  RegionSet regions;
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  const double half = n;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double low = 2.0 * i - n + 0.5;
    std::array<Point, 4> corners = {{{-half, low}, {half, low}, {half, low + 1}, {-half, low + 1}}};
    for (Point& p : corners) p = {c * p.x - s * p.y, s * p.x + c * p.y};
    add_polygon(regions, corners);
  }
  return regions;
}

Workload slabs(std::uint32_t n, std::uint64_t) {
  return single(Operation::intersection, bars(n, 0.3), bars(n, 0.3 + std::numbers::pi / 2));
}

Workload nested(std::uint32_t n, std::uint64_t) {
  RegionSet a, b;
  for (std::uint32_t i = 0; i < n; ++i) {
    // Rings of A and B alternate and share no edge; every second square is a hole of the one around it.
    const double r = 4.0 * (n - i);
    const Point outer[] = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    const Point inner[] = {{2 - r, 2 - r}, {2 - r, r - 2}, {r - 2, r - 2}, {r - 2, 2 - r}};
    add_polygon(a, outer);
    add_hole(a, inner);
    const double turned = r * std::numbers::sqrt2 - 1.5;
    const Point outer_b[] = {{-turned, 0}, {0, -turned}, {turned, 0}, {0, turned}};
    const Point inner_b[] = {{2 - turned, 0}, {0, turned - 2}, {turned - 2, 0}, {0, 2 - turned}};
    add_polygon(b, outer_b);
    add_hole(b, inner_b);
  }
  return single(Operation::symmetric_difference, std::move(a), std::move(b));
}

Workload crossing(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  RegionSet a, b;
  std::vector<Point> contour(n);
  for (RegionSet* operand : {&a, &b}) {
    for (Point& p : contour) p = {1000 * uniform(random), 1000 * uniform(random)};
    add_polygon(*operand, contour);
  }
  return single(Operation::intersection, std::move(a), std::move(b), OperandKind::crossing, OperandKind::crossing,
                FillRule::Kind::even_odd);
}

// Two arms of an Archimedean spiral, one a little turned against the other: long thin windings that cross often.
Workload spiral_pair(std::uint32_t n, std::uint64_t) {
  const auto arm = [n](double turn, double center) {
    std::vector<Point> contour;
    const double windings = std::sqrt(n / 8.0 + 9);
    for (std::uint32_t i = 0; i < n; ++i) {
      const bool back = i >= n / 2;
      const double t = 2.0 * (back ? n - 1 - i : i) / n;
      // Vertices at even distances, from the third winding on: further in, chords would cross.
      const double angle = two_pi * std::sqrt(9 + (windings * windings - 9) * t);
      const double radius = 10 * angle / two_pi + (back ? 9 : 5);
      contour.push_back({center + radius * std::cos(angle + turn), radius * std::sin(angle + turn)});
    }
    return contour;
  };
  RegionSet a, b;
  add_polygon(a, arm(0, 0));
  add_polygon(b, arm(1, 3));
  return single(Operation::intersection, std::move(a), std::move(b));
}

// Pairs of overlapping stars of 10 to 50 vertices.
Workload pairs(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto star = [&random](Point center) {
    const auto count = 10 + static_cast<std::uint32_t>(41 * uniform(random));
    std::vector<Point> contour(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const double angle = two_pi * (i + 0.8 * uniform(random)) / count;
      const double radius = 0.6 + 0.4 * uniform(random);
      contour[i] = {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
    }
    RegionSet regions;
    add_polygon(regions, contour);
    orient(regions);
    return regions;
  };
  Workload workload;
  workload.operation = Operation::intersection;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point center = {1000 * uniform(random), 1000 * uniform(random)};
    workload.a.add(star(center));
    workload.b.add(star({center.x + uniform(random), center.y + uniform(random)}));
  }
  return workload;
}

// The border from one corner of a cell to another, without the second: it sways sideways, less near its ends, so that
// the borders that meet at a corner cross nowhere else.
std::vector<Point> border(Point from, Point to, std::mt19937_64& random) {
  constexpr std::uint32_t steps = 16;
  std::vector<Point> points = {from};
  for (std::uint32_t i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double sway = 0.1 * std::sin(std::numbers::pi * t) * (uniform(random) - 0.5);
    const Point along = {to.x - from.x, to.y - from.y};
    points.push_back({from.x + t * along.x - sway * along.y, from.y + t * along.y + sway * along.x});
  }
  return points;
}

// n x n cells that share their borders vertex by vertex. Every second cell has a hole, and every second hole is
// filled by an enclave.
Workload coverage(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::size_t side = n + 1;
  std::vector<Point> corners;
  for (std::size_t i = 0; i < side * side; ++i) {
    const auto column = static_cast<double>(i % side), row = static_cast<double>(i / side);
    corners.push_back({column + 0.1 * uniform(random), row + 0.1 * uniform(random)});
  }
  std::vector<std::vector<Point>> rightward(side * side), upward(side * side);  // by the corner they begin at
  for (std::size_t i = 0; i < side * side; ++i) {
    if (i % side < n) rightward[i] = border(corners[i], corners[i + 1], random);
    if (i / side < n) upward[i] = border(corners[i], corners[i + side], random);
  }
  RegionSet cells;
  for (std::uint32_t cell = 0; cell < n * n; ++cell) {
    const std::size_t low = cell / n * side + cell % n;
    std::vector<Point> contour = rightward[low];
    contour.insert(contour.end(), upward[low + 1].begin(), upward[low + 1].end());
    contour.push_back(corners[low + side + 1]);
    contour.insert(contour.end(), rightward[low + side].rbegin(), rightward[low + side].rend());
    contour.insert(contour.end(), upward[low].rbegin(), upward[low].rend() - 1);
    add_polygon(cells, contour);
    if (cell % 2 != 0) continue;
    std::vector<Point> hole;
    for (std::uint32_t i = 0; i < 12; ++i) {
      const double angle = two_pi * i / 12;
      const double radius = 0.2 + 0.1 * uniform(random);
      hole.push_back(
          {corners[low].x + 0.5 + radius * std::cos(angle), corners[low].y + 0.5 + radius * std::sin(angle)});
    }
    add_hole(cells, hole);
    if (cell % 4 == 0) add_polygon(cells, hole);
  }
  Workload workload = single(Operation::unite, std::move(cells), {}, OperandKind::overlapping);
  workload.coverage = true;
  return workload;
}

constexpr NamedWorkload workloads[] = {
    {"stars", "vertices of each of the two polygons", stars},
    {"slabs", "bars in each of the two directions", slabs},
    {"nested", "square rings in each operand", nested},
    {"crossing", "vertices of each random self-crossing polygon", crossing},
    {"spiral_pair", "vertices of each spiral", spiral_pair},
    {"pairs", "pairs of small polygons", pairs},
    {"coverage", "cells along each side of a coverage, some with holes and enclaves; dissolved", coverage},
};

}  // namespace

// A star-shaped contour of n vertices: five large waves, fifty small ones, and a wiggle of each vertex by
// up to a third of its spacing. It is simple, because its angles increase.
std::vector<Point> wiggly_star(std::uint32_t n, double phase, std::mt19937_64& random) {
  std::vector<Point> contour(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = two_pi * i / n;
    const double wiggle = (uniform(random) - 0.5) * (two_pi / n) * 2 / 3;
    const double radius =
        1000 * (1 + 0.2 * std::sin(5 * (angle + phase)) + 0.01 * std::sin(50 * (angle - phase)) + wiggle);
    contour[i] = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  return contour;
}

std::span<const NamedWorkload> general_workloads() { return workloads; }

}  // namespace oblast::bench
