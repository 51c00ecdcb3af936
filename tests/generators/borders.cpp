// Hostile generators: edges that lie on one line, exactly or nearly.
#include <algorithm>
#include <cmath>

#include "generators/circle.h"
#include "generators/hostile.h"
#include "generators/soup.h"

namespace oblast::generators {
namespace {

// A simple contour around (10, 10), whose angles around this point increase.
Ring roundish(Random& random, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * (i + 0.8 * random.unit()) / corners;
    const double radius = random.in(2, 9);
    ring.push_back({10 + radius * cosine(angle), 10 + radius * sine(angle)});
  }
  return ring;
}

// Divides the edges of the contour at random places. Rounding moves the new vertices off the line.
Ring divided(const Ring& ring, int steps, Random& random) {
  Ring result;
  for (std::size_t v = 0; v < ring.size(); ++v) {
    const Point &p = ring[v], &q = ring[(v + 1) % ring.size()];
    result.push_back(random.one_in(3) ? Point{nudge(p.x, steps, random), nudge(p.y, steps, random)} : p);
    if (random.one_in(2)) result.push_back(along(p, q, random));
  }
  return result;
}

}  // namespace

Operands t_junctions(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  // A line from `from` to `to`, with cells above it in A and below it in B. Each row has other divisions.
  const bool integers = random.one_in(3);
  const Point from{0.1, 0.2};
  const Point to = integers ? Point{24.1, 0.2} : Point{random.in(3, 30), random.in(-9, 9)};
  for (RegionSet* soup : {&operands.a, &operands.b}) {
    const int cells = std::max(1, size / 8 + random.between(-1, 1));
    const double height = soup == &operands.a ? 1 : -1;
    for (int c = 0; c < cells; ++c) {
      const auto on_line = [&](int i) {
        const double t = static_cast<double>(i) / cells;
        return Point{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
      };
      const Point p = on_line(c), q = on_line(c + 1);
      Ring cell{p, q, {q.x, q.y + height}, {p.x, p.y + height}};
      if (random.one_in(4)) cell.insert(cell.begin() + 1, along(p, q, random));
      add_polygon(random.one_in(6) ? operands.b : *soup, cell);
    }
  }
  if (random.one_in(3)) add_either_way(operands.b, {from, to, {from.x, to.y + 3}}, random);
  return operands;
}

Operands vertices_on_edges(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  const int corners = std::max(3, size / 6);
  Ring outer = roundish(random, corners);
  for (int layer = 0; layer < 4; ++layer) {
    add_either_way(layer % 2 == 0 ? operands.a : operands.b, outer, random);
    Ring inner;
    const int skip = random.between(1, 2);
    for (std::size_t v = 0; v < outer.size(); v += static_cast<std::size_t>(skip)) {
      inner.push_back(along(outer[v], outer[(v + 1) % outer.size()], random));
      if (random.one_in(3)) inner.push_back(along(outer[v], outer[(v + 1) % outer.size()], random));
    }
    if (inner.size() < 3) break;
    if (random.one_in(4)) std::reverse(inner.begin() + 1, inner.end() - 1);  // then it may cross itself
    outer = inner;
  }
  return operands;
}

Operands slivers(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  const Ring ring = roundish(random, std::max(3, size / 4));
  const int steps = random.between(0, 3);
  add_polygon(operands.a, ring);
  add_polygon(operands.b, divided(ring, steps, random));
  if (random.one_in(3)) add_either_way(operands.b, divided(ring, steps, random), random);
  if (random.one_in(3)) add_either_way(operands.a, divided(divided(ring, 1, random), 1, random), random);
  return operands;
}

Operands coverages(std::uint64_t seed, int size) {
  Random random(seed);
  Operands operands;
  int side = 1;
  while (side * side * 8 < size) ++side;
  for (RegionSet* soup : {&operands.a, &operands.b}) {
    // A mesh of moved grid points; cells share borders exactly. The outside border stays where it is.
    const bool integers = random.one_in(3);
    std::vector<Point> mesh;
    for (int i = 0; i <= side; ++i) {
      for (int j = 0; j <= side; ++j) {
        const bool border = i == 0 || j == 0 || i == side || j == side;
        const double dx = border || integers ? 0 : random.in(-0.6, 0.6),
                     dy = border || integers ? 0 : random.in(-0.6, 0.6);
        mesh.push_back({i + dx + 0.1, j + dy + 0.7});
      }
    }
    const auto at = [&](int i, int j) { return mesh[static_cast<std::size_t>(i * (side + 1) + j)]; };
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        if (random.one_in(8)) continue;
        Ring cell{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        if (random.one_in(3)) cell = reversed(cell);
        add_polygon(*soup, cell);
      }
    }
  }
  return operands;
}

}  // namespace oblast::generators
