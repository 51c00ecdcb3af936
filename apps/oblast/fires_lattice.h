// The pixels of one satellite pass: a lattice of parallelograms, and the contours vectorised from it.
//
//        (i, j+1) .-------. (i+1, j+1)      corner (i, j) = origin + i * u + j * v, computed by one
//                /       /                  formula, so that neighbouring pixels share their corners
//        (i, j) .-------. (i+1, j)          bit for bit.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <vector>

namespace oblast::app {

/// A pixel by its column and row, or the lattice corner of the same numbers.
struct Cell {
  std::int32_t i = 0;
  std::int32_t j = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
  friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// Kilometres to degrees as drawn: one cosine (of 60 degrees) for the whole picture keeps lattices affine.
inline constexpr double km_per_degree_lat = 111.2;
inline constexpr double km_per_degree_lon = 55.6;

class Lattice {
 public:
  /// `slope` is the tangent of half the lattice's angle; sizes in kilometres; the origin in degrees.
  Lattice(Point origin, double slope, double width_km, double height_km);

  Point corner(Cell c) const { return {origin_.x + c.i * u_.x + c.j * v_.x, origin_.y + c.i * u_.y + c.j * v_.y}; }
  /// The pixel that holds a place (degrees).
  Cell cell_at(Point place) const;
  /// The pixels whose centre is at most `radius_km` from a place, in order; perhaps none.
  std::vector<Cell> disc(Point place, double radius_km) const;

 private:
  Point origin_;
  double cosine_, sine_, width_, height_;
  Point u_, v_;  // degrees a column and a row
};

/// The pixels and those they enclose, sorted. Where two pixels touch by a corner only, the walk
/// around them encloses one of the two pixels between, so afterwards no outline meets itself.
std::vector<Cell> without_gaps(const std::vector<Cell>& cells);

/// Pixels that hang together by their sides, as the vectoriser sees them. Takes sorted cells.
std::vector<std::vector<Cell>> components(const std::vector<Cell>& cells);

/// One vertex of an outline. A corner that lies straight between its neighbours may be left out.
struct OutlineVertex {
  Cell corner;
  bool straight = false;
};

/// The outline of a component without gaps, counter-clockwise in (i, j), every lattice corner along it.
std::vector<OutlineVertex> outline(const std::vector<Cell>& component);

}  // namespace oblast::app
