// Sklansky's scan of 1972, which is wrong for some simple polygons: kept to show that the tests' polygons fool it.
#pragma once

#include <oblast/point.h>

#include <vector>

namespace oblast::tests {

/// The corners counter-clockwise from the smallest. `ring`: simple, counter-clockwise.
std::vector<Point> sklansky_scan(std::vector<Point> ring);

}  // namespace oblast::tests
