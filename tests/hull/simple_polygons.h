// Random simple polygons of many kinds. Each is simple by the way it is made.
#pragma once

#include <oblast/point.h>

#include <span>
#include <vector>

#include "generators/random.h"

namespace oblast::tests {

using generators::Random;

struct SimpleKind {
  const char* name;
  /// About n vertices, 3 or more; either direction, from any vertex.
  std::vector<Point> (*make)(Random& random, int n);
};

/// star, monotone, spiral, maze, comb, collinear runs.
std::span<const SimpleKind> simple_kinds();

std::vector<Point> star(Random& random, int n);
std::vector<Point> monotone(Random& random, int n);
std::vector<Point> spiral(Random& random, int n);
/// The outline of a random tree of cells that fills a square: every vertex on a lattice, pockets in pockets.
std::vector<Point> maze(Random& random, int n);
std::vector<Point> comb(Random& random, int n);
/// Another kind on a lattice, with points put onto its edges.
std::vector<Point> collinear_runs(Random& random, int n);

/// Turned by quarters, mirrored, reversed, begun elsewhere: still simple.
std::vector<Point> moved_about(Random& random, std::vector<Point> ring);

}  // namespace oblast::tests
