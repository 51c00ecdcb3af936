#include "inputs.h"

#include <cmath>
#include <random>

namespace oblast::bench {
namespace {

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// Uniform in a square, no sides.
TriangulationInput random_points(std::size_t n) {
  std::mt19937_64 random(1);
  TriangulationInput input;
  for (std::size_t i = 0; i < n; ++i) input.points.push_back({uniform(random), uniform(random)});
  return input;
}

/// One segment in each cell of a lattice, as long as the cell allows. About half are not sides of the Delaunay
/// triangulation.
TriangulationInput random_segments(std::size_t n) {
  std::mt19937_64 random(2);
  TriangulationInput input;
  const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / 2));
  for (std::size_t x = 0; x < cells; ++x) {
    for (std::size_t y = 0; y < cells; ++y) {
      const double left = uniform(random), right = uniform(random);
      input.sides.push_back({input.points.size(), input.points.size() + 1});
      input.points.push_back({static_cast<double>(x) + 0.01, static_cast<double>(y) + 0.02 + 0.9 * left});
      input.points.push_back({static_cast<double>(x) + 0.99, static_cast<double>(y) + 0.02 + 0.9 * right});
    }
  }
  return input;
}

/// A closed line around the origin with waves of several lengths.
TriangulationInput wiggly_polygon(std::size_t n) {
  std::mt19937_64 random(3);
  TriangulationInput input;
  const double turn = 6.283185307179586;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = turn * static_cast<double>(i) / static_cast<double>(n);
    const double r = 100 + 10 * std::sin(7 * t) + 3 * std::sin(101 * t) + std::sin(1009 * t) +
                     20 * uniform(random) / std::sqrt(static_cast<double>(n));
    input.points.push_back({r * std::cos(t), r * std::sin(t)});
    input.sides.push_back({i, i + 1 == n ? 0 : i + 1});
  }
  return input;
}

/// The squares of a lattice with whole coordinates. Each side is shared, and everything is cocircular.
TriangulationInput lattice(std::size_t n) {
  TriangulationInput input;
  const auto size = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  for (std::size_t x = 0; x < size; ++x) {
    for (std::size_t y = 0; y < size; ++y) {
      const std::size_t i = input.points.size();
      if (x + 1 < size) input.sides.push_back({i, i + size});
      if (y + 1 < size) input.sides.push_back({i, i + 1});
      input.points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  return input;
}

constexpr NamedInput inputs[] = {
    {"points", random_points}, {"segments", random_segments}, {"polygon", wiggly_polygon}, {"lattice", lattice}};

}  // namespace

std::span<const NamedInput> triangulation_inputs() { return inputs; }

}  // namespace oblast::bench
