// Cells of points for the drivers of zones: clipped to the box of the points, written as polygons of shape_file.h.
#pragma once

#include <algorithm>
#include <vector>

#include "buffers/shape_file.h"

namespace zones {

using buffers::Xy;

struct Frame {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;

  explicit Frame(const std::vector<Xy>& points) {
    for (const Xy& p : points) {
      x0 = std::min(x0, p.x);
      y0 = std::min(y0, p.y);
      x1 = std::max(x1, p.x);
      y1 = std::max(y1, p.y);
    }
  }
  bool holds(const Xy& p) const { return x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1; }
  /// Four points so far away that the cells of all others are finite, and change only outside of the box.
  std::vector<Xy> far_away() const {
    const double far = 8 * std::max(x1 - x0, y1 - y0), x = (x0 + x1) / 2, y = (y0 + y1) / 2;
    return {{x - far, y}, {x + far, y}, {x, y - far}, {x, y + far}};
  }
};

/// The part of a convex ring on one side of a line of the frame: Sutherland and Hodgman. `over` is positive outside,
/// and a new point gets the coordinate of the line.
template <class Over>
void cut(std::vector<Xy>& ring, const Over& over, double Xy::*coordinate, double line) {
  std::vector<Xy> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Xy &a = ring[i], &b = ring[i + 1 == ring.size() ? 0 : i + 1];
    const double at_a = over(a), at_b = over(b);
    if (at_a <= 0) kept.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
      // From the outer end, so that the cells on both sides of the edge get the same point.
      const Xy &out = at_a > 0 ? a : b, &in = at_a > 0 ? b : a;
      const double share = std::max(at_a, at_b) / (std::max(at_a, at_b) - std::min(at_a, at_b));
      Xy& made = kept.emplace_back(Xy{out.x + share * (in.x - out.x), out.y + share * (in.y - out.y)});
      made.*coordinate = line;
    }
  }
  ring = std::move(kept);
}

/// Adds a cell as a polygon.
inline void add_cell(std::vector<Xy>& ring, const Frame& frame, buffers::Shapes& cells) {
  if (!std::all_of(ring.begin(), ring.end(), [&](const Xy& p) { return frame.holds(p); })) {
    cut(
        ring, [&](const Xy& p) { return frame.x0 - p.x; }, &Xy::x, frame.x0);
    cut(
        ring, [&](const Xy& p) { return p.x - frame.x1; }, &Xy::x, frame.x1);
    cut(
        ring, [&](const Xy& p) { return frame.y0 - p.y; }, &Xy::y, frame.y0);
    cut(
        ring, [&](const Xy& p) { return p.y - frame.y1; }, &Xy::y, frame.y1);
  }
  cells.add_ring(ring);
  cells.end_polygon();
}

/// The main function of a driver: cells_of(points) makes the cells.
template <class CellsOf>
int drive(int argc, char** argv, const CellsOf& cells_of) {
  const auto make = [&](const buffers::Arguments& arguments) {
    return [&] { return cells_of(arguments.shapes.points); };
  };
  return buffers::drive(argc, argv, make, [](const buffers::Shapes& cells) { return cells; });
}

}  // namespace zones
