// The pockets beside a new constraint: triangles taken out, and new ones put in.
//
//          b1--b2                    left pocket:   to, b2, b1, from
//         /      \                   right pocket:  from, a1, a2, to
//     from ------ to                 every vertex sees the constraint, since a side that crosses it ended
//         \      /                   there; so a strictly convex corner is always an ear, and one pass
//          a1--a2                    with a stack fills the pocket (Toussaint and Avis 1982).
//
// A side whose two triangles are both taken out dangles: it is twice on the border of the pocket.
#pragma once

#include "base/call_memory.h"
#include "triangulation/mesh.h"

namespace oblast::internal::triangulation {

class Pocket {
 public:
  /// `leaving`, by vertex some half-edge with that origin, is kept right.
  Pocket(Mesh& mesh, Array<HalfEdge>& leaving) : mesh_(mesh), leaving_(leaving) {}

  /// Empties the pocket for another constraint.
  void begin(std::uint32_t from, std::uint32_t to);
  /// Takes a triangle out.
  void take(std::uint32_t triangle);
  /// The borders, half-edges of triangles taken out, each in the order from `from` to `to`.
  void add_right(HalfEdge h) { right_.push_back(h); }
  void add_left(HalfEdge h) { left_.push_back(h); }

  /// Fills both pockets with triangles that are not yet Delaunay, the constraint between them, and appends
  /// their inner sides to `new_sides`. Gives the constraint's half-edge from `from` to `to`.
  HalfEdge fill(Array<HalfEdge>& new_sides);

 private:
  /// A side of the border that waits for the triangle inside.
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
  Array<std::uint32_t> free_;  ///< triangles taken out
  Array<HalfEdge> right_, left_;
  Border right_border_, left_border_, stack_;  ///< borders are counter-clockwise around their pocket
};

}  // namespace oblast::internal::triangulation
