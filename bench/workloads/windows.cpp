// Workloads in which one operand is convex: clipping by a window, and pairs of convex polygons.
#include <array>
#include <cmath>
#include <numbers>

#include "workloads/workloads.h"

namespace oblast::bench {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

Workload star_and(std::uint32_t n, std::uint64_t seed, const RegionSet& window) {
  std::mt19937_64 random(seed);
  RegionSet a;
  add_polygon(a, wiggly_star(n, 0, random));
  return single(Operation::intersection, std::move(a), window);
}

// About one vertex in seventy of the star is inside.
Workload small_window(std::uint32_t n, std::uint64_t seed) {
  RegionSet window;
  add_rectangle(window, 850.5, -49.5, 950.5, 50.5);
  return star_and(n, seed, window);
}

// Nearly half of the star is inside.
Workload large_window(std::uint32_t n, std::uint64_t seed) {
  RegionSet window;
  add_rectangle(window, 0.5, -1499.5, 1500.5, 1500.5);
  return star_and(n, seed, window);
}

Workload octagon(std::uint32_t n, std::uint64_t seed) {
  std::array<Point, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double angle = two_pi * (static_cast<double>(i) + 0.3) / 8;
    corners[i] = {700 + 400 * std::cos(angle), 400 * std::sin(angle)};
  }
  RegionSet window;
  add_polygon(window, corners);
  return star_and(n, seed, window);
}

RegionSet small_polygon(Point center, std::uint32_t count, double least_radius, std::mt19937_64& random) {
  std::vector<Point> contour(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = two_pi * (i + 0.8 * uniform(random)) / count;
    const double radius = least_radius + (1 - least_radius) * uniform(random);
    contour[i] = {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
  }
  RegionSet regions;
  add_polygon(regions, contour);
  return regions;
}

// Polygons of 10 to 50 vertices and one window. Of ten polygons about four are inside, three across and three outside.
Workload window_pairs(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  RegionSet window;
  add_rectangle(window, 0, 0, 10, 10);
  Workload workload;
  workload.operation = Operation::intersection;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point center = {13 * uniform(random) - 1.5, 13 * uniform(random) - 1.5};
    const auto count = 10 + static_cast<std::uint32_t>(41 * uniform(random));
    workload.a.add(small_polygon(center, count, 0.6, random));
    workload.b.add(window);
  }
  return workload;
}

// Convex polygons of 4 to 20 vertices that overlap.
Workload convex_pairs(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Workload workload;
  workload.operation = Operation::intersection;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point center = {1000 * uniform(random), 1000 * uniform(random)};
    for (Operand* operand : {&workload.a, &workload.b}) {
      const auto count = 4 + static_cast<std::uint32_t>(17 * uniform(random));
      operand->add(small_polygon({center.x + uniform(random), center.y + uniform(random)}, count, 1, random));
    }
  }
  return workload;
}

constexpr NamedWorkload workloads[] = {
    {"small_window", "vertices of the polygon clipped", small_window},
    {"large_window", "vertices of the polygon clipped", large_window},
    {"octagon", "vertices of the polygon clipped", octagon},
    {"window_pairs", "polygons clipped by one window", window_pairs},
    {"convex_pairs", "pairs of convex polygons", convex_pairs},
};

}  // namespace

std::span<const NamedWorkload> window_workloads() { return workloads; }

}  // namespace oblast::bench
