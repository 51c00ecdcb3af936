// The pockets beside a new constraint: triangles are removed, and new triangles fill the space.
//
//          b1--b2                    left pocket:   to, b2, b1, from
//         /      \                   right pocket:  from, a1, a2, to
//     from ------ to                 every vertex sees the constraint, because a side that crossed the
//         \      /                   constraint ended there; so a strictly convex corner is always an ear,
//          a1--a2                    and one pass with a stack fills the pocket (Toussaint and Avis 1982).
//
// If both triangles of a side are removed, the side dangles: it is on the border of the pocket twice.
#pragma once

#include "base/call_memory.h"
#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

class Pocket {
 public:
  /// `leaving` (by vertex: some half-edge with that origin) is updated.
  Pocket(Mesh& mesh, Array<HalfEdge>& leaving) : mesh_(mesh), leaving_(leaving) {}

  /// Empties the pocket for the next constraint.
  void begin(std::uint32_t from, std::uint32_t to);
  /// Removes a triangle.
  void take(std::uint32_t triangle);
  /// Add to the borders: half-edges of removed triangles, each border in the order from `from` to `to`.
  void add_right(HalfEdge h) { right_.push_back(h); }
  void add_left(HalfEdge h) { left_.push_back(h); }

  /// Fills both pockets, with the constraint between them, with triangles that are not yet Delaunay. Appends their
  /// inner sides to `new_sides`. Returns the half-edge of the constraint from `from` to `to`.
  HalfEdge fill(Array<HalfEdge>& new_sides);

 private:
  /// A side of the border whose inner triangle is not yet made.
  struct Side {
    std::uint32_t origin;
    HalfEdge beyond;        ///< the half-edge on its other side. Where it dangles: its own, once there is one
    std::uint32_t partner;  ///< where it dangles: its other place in the border; else none
    std::uint32_t constrained;
  };
  using Border = Array<Side>;

  void read(const Array<HalfEdge>& half_edges, Border& border);
  HalfEdge fill_one(Border& border, std::uint32_t end, Array<HalfEdge>& new_sides);
  std::uint32_t make_triangle(std::uint32_t x, std::uint32_t y, std::uint32_t z);
  void attach(HalfEdge made, const Side& side, Border& border);

  Mesh& mesh_;
  Array<HalfEdge>& leaving_;
  std::uint32_t from_ = 0, to_ = 0;
  Array<std::uint32_t> free_;  ///< removed triangles
  Array<HalfEdge> right_, left_;
  Border right_border_, left_border_, stack_;  ///< borders are counter-clockwise around their pocket
};

}  // namespace oblast::internal::triangulation
