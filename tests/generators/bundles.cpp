// Hostile generators: many edges through one point.
#include <algorithm>
#include <cmath>

#include "generators/circle.h"
#include "generators/hostile.h"
#include "generators/soup.h"

namespace oblast::generators {

Operands near_parallel_bundles(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  const Point from{random.in(0, 1), random.in(0, 1)};
  const Point to{random.in(5, 100), random.in(-100, 100)};
  const int steps = random.between(1, 8);
  for (int edges = 0; edges < size; edges += 4) {
    // A sliver that runs back and forth along one line. Its four corners are within a few units of the line.
    Ring ring;
    for (const Point& p : {from, to}) {
      ring.push_back(random.one_in(2) ? p : along(from, to, random));
      ring.push_back(random.one_in(3) ? along(from, to, random) : p);
    }
    if (random.one_in(2)) std::swap(ring[1], ring[2]);
    if (random.one_in(4)) ring.push_back({random.in(0, 10), random.in(-10, 10)});
    ring = nudge(ring, steps, random);
    add_either_way(random.one_in(2) ? operands.a : operands.b, ring, random);
  }
  return operands;
}

Operands fans(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  const bool integers = random.one_in(2);
  const Point hub = integers ? Point{0, 0} : Point{random.in(1, 2), random.in(1, 2)};
  const double radius = integers ? 12 : random.in(1, 1000);
  const auto rim = [&]() -> Point {
    if (integers) return {static_cast<double>(random.between(-12, 12)), static_cast<double>(random.between(-12, 12))};
    const double angle = random.in(0, 6.283185307179586);
    return {hub.x + radius * cosine(angle), hub.y + radius * sine(angle)};
  };
  for (int edges = 0; edges < size; edges += 3) {
    RegionSet& soup = random.one_in(2) ? operands.a : operands.b;
    const Point p = rim();
    switch (random.below(4)) {
      case 0:  // a blade so thin that it may close
        add_either_way(soup, {hub, p, {nudge(p.x, 4, random), nudge(p.y, 4, random)}}, random);
        break;
      case 1:  // through the hub to the other side, twice
        add_either_way(soup, {p, hub, rim(), rim(), hub, rim()}, random);
        edges += 3;
        break;
      default:
        add_either_way(soup, {hub, p, rim()}, random);
    }
  }
  return operands;
}

Operands combs(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  const bool rounded = random.one_in(2);
  const double scale = rounded ? 0.1 : 1;
  const int teeth = std::max(2, size / 4);
  const Point tip{scale * random.between(0, teeth), scale * random.between(4, 9)};
  // Bases on the line y = 0 or y = 14, all teeth pointing at the tip.
  for (RegionSet* soup : {&operands.a, &operands.b}) {
    const double base = soup == &operands.a || random.one_in(3) ? 0 : 14 * scale;
    const double shift = random.one_in(2) ? 0 : 0.5 * scale;
    const double spine = base == 0 ? -scale : 15 * scale;
    Ring comb{{shift, spine}};
    for (int t = 0; t < teeth; ++t) {
      comb.push_back({scale * t + shift, base});
      const bool exact = !rounded || random.one_in(2);
      comb.push_back(exact ? tip : Point{nudge(tip.x, 2, random), nudge(tip.y, 2, random)});
    }
    comb.push_back({scale * teeth + shift, base});
    comb.push_back({scale * teeth + shift, spine});
    add_polygon(*soup, comb);
  }
  return operands;
}

Operands stars(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  for (RegionSet* soup : {&operands.a, &operands.b}) {
    // Chords of a circle, each nearly a diameter: they all cross within a small neighbourhood.
    const double offset = random.one_in(2) ? 0 : random.in(-1, 1);
    Ring star;
    const int corners = std::max(4, size / 2);
    const int step = std::max(1, corners / 2 - random.below(3));
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.283185307179586 * ((static_cast<double>(i) * step) / corners) + offset;
      star.push_back({10 + 3 * cosine(angle), 10 + 3 * sine(angle)});
      if (random.one_in(3)) star.back() = {random.in(7, 13), random.in(7, 13)};
    }
    add_polygon(*soup, star);
  }
  return operands;
}

}  // namespace oblast::generators
