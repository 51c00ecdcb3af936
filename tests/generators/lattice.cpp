// Hostile generators: inputs in which everything coincides.
#include <algorithm>

#include "generators/hostile.h"
#include "generators/soup.h"

namespace oblast::generators {
namespace {

// Contours with corners on the integers of [low, low + extent]^2.
RegionSet lattice_soup(Random& random, int edges, int low, int extent) {
  RegionSet soup;
  while (edges > 0) {
    Ring ring;
    const int corners = random.between(3, 7);
    const bool box = random.one_in(3);
    const auto coordinate = [&] { return static_cast<double>(low + random.below(extent + 1)); };
    if (box) {
      const double x = coordinate(), y = coordinate();
      const double width = random.between(1, 3), height = random.between(1, 3);
      ring = rectangle(x, y, x + width, y + height);
      if (random.one_in(2)) ring = reversed(ring);
    } else {
      for (int i = 0; i < corners; ++i) ring.push_back({coordinate(), coordinate()});
    }
    add_either_way(soup, ring, random);
    edges -= static_cast<int>(ring.size());
  }
  return soup;
}

}  // namespace

Operands integer_grid(std::uint64_t seed, int size) {
  Random random(seed);
  const int extent = random.between(2, 9), low = random.one_in(2) ? 0 : -extent / 2;
  Operands operands{lattice_soup(random, size / 2, low, extent), lattice_soup(random, size / 2, low, extent)};
  if (random.one_in(4)) {
    for (Point& p : operands.a.points) {
      if (p.x == 0 && random.one_in(2)) p.x = -0.0;
      if (p.y == 0 && random.one_in(2)) p.y = -0.0;
    }
  }
  return operands;
}

Operands grid_by_an_ulp(std::uint64_t seed, int size) {
  Random random(seed);
  const int extent = random.between(2, 6), low = random.one_in(2) ? 1 : -extent / 2;
  Operands operands{lattice_soup(random, size / 2, low, extent), lattice_soup(random, size / 2, low, extent)};
  const int steps = random.between(1, 2);
  for (RegionSet* soup : {&operands.a, &operands.b}) {
    for (Point& p : soup->points) p = {nudge(p.x, steps, random), nudge(p.y, steps, random)};
  }
  return operands;
}

Operands copies_of_one_square(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  Ring square = rectangle(1, 1, 3, 3);
  if (random.one_in(2)) square = {{1.1, 2.3}, {2.3, 1.3}, {3.7, 2.1}, {2.1, 3.9}};
  const int steps = random.below(3);
  const int copies = std::max(2, size / 4);
  const int exact_copies = std::max(4, copies / 50);  // one in this many is nudged; any two nudged copies cross
  for (int i = 0; i < copies; ++i) {
    Ring copy = square;
    if (random.one_in(exact_copies)) copy = nudge(copy, steps, random);
    if (random.one_in(4)) copy = reversed(copy);
    std::rotate(copy.begin(), copy.begin() + random.below(4), copy.end());
    add_either_way(random.one_in(2) ? operands.a : operands.b, copy, random);
  }
  return operands;
}

Operands nested_squares(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  const bool rounded = random.one_in(2);
  // Each square has its corners on the midpoints of the sides of the square around it.
  Ring square = rectangle(0, 0, 64, 64);
  if (rounded) square = {{0.1, 0.3}, {64.7, -0.9}, {65.3, 64.1}, {0.7, 63.3}};
  for (int i = 0; i < std::max(2, size / 4); ++i) {
    const Ring drawn = random.one_in(2) ? reversed(square) : square;
    RegionSet& soup = random.one_in(3) ? operands.b : operands.a;
    if (random.one_in(2)) {
      add_hole(soup, drawn);
    } else {
      add_polygon(soup, drawn);
    }
    if (random.one_in(8)) continue;  // twice
    Ring inner;
    const double t = rounded ? random.in(0.3, 0.7) : 0.5;
    for (std::size_t v = 0; v < 4; ++v) {
      const Point &p = square[v], &q = square[(v + 1) % 4];
      inner.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
    square = inner;
    if (i % 12 == 11) square = rectangle(0, 0, 64, 64);  // before the squares become too small to tell apart
  }
  return operands;
}

Operands checkerboards(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  const double shift = random.one_in(2) ? 0.5 : random.one_in(2) ? 0.0 : 0.1;
  const double step = random.one_in(2) ? 1.0 : 0.1;
  int side = 2;
  while (side * side * 4 < size) ++side;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const double x = i * step, y = j * step;
      RegionSet& soup = (i + j) % 2 == 0 ? operands.a : operands.b;
      const double dx = &soup == &operands.b ? shift * step : 0;
      if (!random.one_in(6)) add_polygon(soup, rectangle(x + dx, y + dx, x + dx + step, y + dx + step));
    }
  }
  return operands;
}

}  // namespace oblast::generators
