// Hostile generators: usual and very unusual magnitudes of coordinates.
#include <oblast/domain.h>

#include <algorithm>
#include <cmath>

#include "generators/circle.h"
#include "generators/hostile.h"
#include "generators/soup.h"

namespace oblast::generators {
namespace {

// Cells of a rotated pixel lattice, single or merged into L shapes, like the detections of one satellite pass.
RegionSet pixels(Random& random, int edges, Point origin, double step, double grain) {
  RegionSet soup;
  const double angle = random.in(-0.6, 0.6);
  const double c = step * cosine(angle), s = step * sine(angle);
  const auto corner = [&](int i, int j) -> Point {
    const Point p{origin.x + i * c - j * s, origin.y + i * s + j * c};
    if (grain == 0) return p;
    return {std::round(p.x / grain) * grain, std::round(p.y / grain) * grain};
  };
  while (edges > 0) {
    const int i = random.below(5), j = random.below(5);
    Ring ring{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
    if (random.one_in(3)) {
      ring = {corner(i, j),         corner(i + 2, j),     corner(i + 2, j + 1),
              corner(i + 1, j + 1), corner(i + 1, j + 2), corner(i, j + 2)};
    }
    if (random.one_in(4)) ring = reversed(ring);
    add_polygon(soup, ring);
    edges -= static_cast<int>(ring.size());
  }
  return soup;
}

Operands two_passes(std::uint64_t seed, int size, Point origin, double step, double grain) {
  Random random(seed);
  if (random.one_in(3)) grain = 0;
  RegionSet a = pixels(random, size / 2, origin, step, grain);
  const Point moved{origin.x + step * random.in(-1, 1), origin.y + step * random.in(-1, 1)};
  return {std::move(a), pixels(random, size / 2, random.one_in(3) ? origin : moved, step, grain)};
}

}  // namespace

Operands spirals(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  const bool squared = random.one_in(2);
  const int corners = std::max(4, size / 4);
  const double thickness = random.in(0.1, 0.7);
  for (RegionSet* soup : {&operands.a, &operands.b}) {
    const Point centre = soup == &operands.a ? Point{0, 0}
                         : squared           ? Point{static_cast<double>(random.between(-2, 2)), thickness}
                                             : Point{random.in(-2, 2), random.in(-2, 2)};
    Ring there, back;
    for (int i = 0; i < corners; ++i) {
      const int turn = i / 4;
      const double angle = squared ? 1.5707963267948966 * i + 0.7853981633974483 : 0.7 * i;
      const double radius = squared ? turn + 1 : 1 + 0.11 * i;
      const double dx = squared ? (cosine(angle) > 0 ? 1.0 : -1.0) : cosine(angle);
      const double dy = squared ? (sine(angle) > 0 ? 1.0 : -1.0) : sine(angle);
      there.push_back({centre.x + radius * dx, centre.y + radius * dy});
      back.push_back({centre.x + (radius + thickness) * dx, centre.y + (radius + thickness) * dy});
    }
    there.insert(there.end(), back.rbegin(), back.rend());
    add_polygon(*soup, there);
  }
  return operands;
}

Operands magnitudes(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  // All at one extreme, or each coordinate at its own.
  const int common = random.between(-290, 296);
  const bool mixed = random.one_in(2);
  const auto coordinate = [&] {
    if (random.one_in(8)) return 0.0;
    const int exponent = mixed ? random.between(-299, 299) : common + random.between(-2, 2);
    const double mantissa = random.one_in(3) ? random.between(1, 3) * 0.5 : random.in(0.5, 1);
    return std::ldexp(random.one_in(2) ? mantissa : -mantissa, exponent);
  };
  std::vector<double> used;
  for (int edges = 0; edges < size;) {
    Ring ring;
    const int corners = random.between(3, 6);
    for (int i = 0; i < corners; ++i) {
      const auto one = [&] {
        // Values are reused, so edges share lines and vertices.
        if (used.empty() || random.one_in(2)) used.push_back(coordinate());
        return used[static_cast<std::size_t>(random.below(static_cast<int>(used.size())))];
      };
      const double x = one();
      ring.push_back({x, one()});
    }
    add_either_way(random.one_in(2) ? operands.a : operands.b, ring, random);
    edges += corners;
  }
  return operands;
}

Operands earth_degrees(std::uint64_t seed, int size) {
  Random random(seed ^ 0xdeu);
  const Point origin{random.in(30, 180), random.in(50, 72)};
  const double grain =
      random.one_in(2) ? 1e-6 : 1e-4;  // drawn in statements: compilers differ in the order of arguments
  return two_passes(seed, size, origin, random.one_in(2) ? 0.01 : 0.00375, grain);
}

Operands earth_metres(std::uint64_t seed, int size) {
  Random random(seed ^ 0x3eu);
  const Point origin{random.in(1e5, 9e5), random.in(5e6, 8e6)};
  const double grain = random.one_in(2) ? 1e-3 : 1;
  return two_passes(seed, size, origin, random.one_in(2) ? 375 : 1000, grain);
}

Operands far_from_origin(std::uint64_t seed, int size) {
  Random random(seed);
  // Shapes of a few thousand units in the last place, or of a few: the lattice of doubles is coarse here.
  const double ulp = std::ldexp(1.0, random.between(-20, 20));
  const double base = std::ldexp(ulp, 52);
  const int extent = random.one_in(2) ? random.between(4, 20) : random.between(100, 4000);
  Operands operands;
  for (int edges = 0; edges < size;) {
    Ring ring;
    const int corners = random.between(3, 6);
    for (int i = 0; i < corners; ++i) {
      ring.push_back({base + ulp * random.below(extent), base + ulp * random.below(extent)});
    }
    add_either_way(random.one_in(2) ? operands.a : operands.b, ring, random);
    edges += corners;
  }
  return operands;
}

}  // namespace oblast::generators
