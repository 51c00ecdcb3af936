// The pixels of one satellite pass: a lattice of parallelograms, and the contours vectorised from it.
//
//        (i, j+1) .-------. (i+1, j+1)      corner (i, j) = origin + i * u + j * v. One formula
//                /       /                  computes all corners, so neighbouring pixels have
//        (i, j) .-------. (i+1, j)          the same corners, bit for bit.
#pragma once

#include <oblast/point.h>

#include <cstdint>
#include <vector>

namespace oblast::app {

/// A pixel, given by its column and row; or the lattice corner with the same numbers.
struct Cell {
  std::int32_t i = 0;
  std::int32_t j = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
  friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// Kilometres per degree. One cosine (of 60 degrees) is used everywhere, so lattices are affine.
inline constexpr double km_per_degree_lat = 111.2;
inline constexpr double km_per_degree_lon = 55.6;

class Lattice {
 public:
  /// `slope` is the tangent of half the lattice's angle; sizes in kilometres; the origin in degrees.
  Lattice(Point origin, double slope, double width_km, double height_km);

  Point corner(Cell c) const { return {origin_.x + c.i * u_.x + c.j * v_.x, origin_.y + c.i * u_.y + c.j * v_.y}; }
  /// The pixel that holds a place (degrees).
  Cell cell_at(Point place) const;
  /// The pixels whose centre is at most `radius_km` from a place, sorted. There may be none.
  std::vector<Cell> disc(Point place, double radius_km) const;

 private:
  Point origin_;
  double cosine_, sine_, width_, height_;
  Point u_, v_;  // degrees a column and a row
};

/// The pixels and those that they enclose, sorted. If two pixels touch at a corner only, the walk around them encloses
/// one of the two pixels between them. So afterwards no outline meets itself.
std::vector<Cell> without_gaps(const std::vector<Cell>& cells);

/// The components of pixels that are connected through sides. REQUIRES: `cells` is sorted.
std::vector<std::vector<Cell>> components(const std::vector<Cell>& cells);

/// A vertex of an outline. A corner on the line between its neighbours (`straight`) may be left out.
struct OutlineVertex {
  Cell corner;
  bool straight = false;
};

/// The outline of a component without gaps, counter-clockwise in (i, j). It has every lattice corner along the way.
std::vector<OutlineVertex> outline(const std::vector<Cell>& component);

}  // namespace oblast::app
