// Whether a piece of an edge is short enough (sampling.h).
//
// A site of another object can belong to a place nearer to the piece only if the circle of some triangle is cut by the
// piece. These triangles are connected, and some of them have the piece's first site as a corner. So they are found by a
// flood from there.
#pragma once

#include <cstdint>

#include "base/call_memory.h"
#include "zones/diagram.h"

namespace oblast::internal::zoning {

class PieceCheck {
 public:
  /// `leaving`: by vertex of the diagram, some half-edge with that origin.
  PieceCheck(const Diagram& diagram, const Array<HalfEdge>& leaving, const Room& room)
      : diagram_(diagram), leaving_(leaving), tolerance_(room.tolerance), margin_(8 * room.unit) {}

  /// How many times the piece is to be halved: 0 if it is short enough. `first`, `last`: vertices of its ends.
  int halvings(std::uint32_t first, std::uint32_t last, std::uint32_t object);

  /// Whether the last piece is short enough only because of epsilon: it may pass through cells of other objects.
  bool is_narrow() const { return narrow_; }

  /// The largest epsilon that a piece needed which was short enough.
  double error() const { return error_; }

 private:
  void begin_flood();
  void reach(std::uint32_t triangle);
  void look_at(std::uint32_t triangle);
  void look_at_crossing(HalfEdge side);
  void judge(double depth, double radius);

  const Diagram& diagram_;
  const Array<HalfEdge>& leaving_;
  double tolerance_, margin_;
  double error_ = 0;

  // Of the piece:
  Point a_, b_;
  std::uint32_t object_ = 0;
  bool narrow_ = false;
  double depth_ = 0;   ///< the largest one that was found
  double radius_ = 0;  ///< the largest one of circles that the piece cuts too deep
  Array<std::uint32_t> waiting_;
  Array<std::uint32_t> slots_;  ///< a hash table of the triangles that were reached; none where free
  Array<std::uint32_t> reached_;
};

}  // namespace oblast::internal::zoning
