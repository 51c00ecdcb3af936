// Whether a piece of an edge is short enough (sampling.h).
//
// Say the piece s belongs to object j, and the place y to the site p of another object i. Then y is as far from i as
// from p, or less: not further than from the pieces of i that end at p. So what is asked is that for some such piece g
// (or for two that go straight on, as one), or for p itself,
//
//     distance(y, g) <= distance(y, s) + epsilon        for all y of the cell of p
//
// On either side of s, and between the perpendiculars at its ends, the difference of the two is a convex function of y.
// (Beyond the perpendiculars p is not further than s.) So it is largest at the corners of the cell, and where the
// border of the cell crosses s.
//
// A site of another object can belong to a place nearer to the piece only if the circle of some triangle is cut by the
// piece. These triangles are connected, and some of them have the piece's first site as a corner. So they are found by
// a flood from there.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "zones/diagram.h"

namespace oblast::internal::zoning {

/// The pieces of all edges, in terms of the vertices of a diagram.
struct PieceEnds {
  struct Ends {
    std::uint32_t first, last;
  };
  Array<Ends> of_piece;
  Array<std::array<std::uint32_t, 2>> at_vertex;  ///< two pieces of the object of the vertex that end there, or none
  Array<HalfEdge> leaving;                        ///< by vertex: some half-edge with that origin
};

class PieceCheck {
 public:
  PieceCheck(const Diagram& diagram, const PieceEnds& ends, const Room& room)
      : diagram_(diagram), ends_(ends), room_(room), margin_(8 * room.unit) {}

  /// How many times the piece is to be halved: 0 if it is short enough. `first`, `last`: vertices of its ends.
  int halvings(std::uint32_t first, std::uint32_t last, std::uint32_t object);

  /// Whether the last piece is so near to sites of other objects, or to borders of their cells, that it may pass
  /// through them, once borders are flattened.
  bool is_narrow() const { return narrow_; }

  /// The largest epsilon that a piece needed which was short enough.
  double error() const { return error_; }

 private:
  void begin_flood();
  void reach(std::uint32_t triangle);
  void look_at(std::uint32_t triangle);
  void look_at_crossing(HalfEdge side);
  void judge(const Point& at, double radius, std::span<const std::uint32_t> sites);
  void relax(const Point& at, double apart, double radius, std::uint32_t site);

  const Diagram& diagram_;
  const PieceEnds& ends_;
  const Room& room_;
  double margin_;  ///< for the errors of distances
  double error_ = 0;

  // Of the piece:
  Point a_, b_;
  std::uint32_t object_ = 0;
  bool narrow_ = false;
  double depth_ = 0;  ///< the largest one that was found, by distances from sites
  /// A site that alone would not do, and the largest difference for each of its pieces.
  struct Relaxed {
    std::uint32_t site;
    double difference[3];

    double needed() const { return std::min({difference[0], difference[1], difference[2]}); }
  };
  Array<Relaxed> relaxed_;
  double radius_ = 0;  ///< the largest one of circles that the piece cuts too deep
  Array<std::uint32_t> waiting_;
  Array<std::uint32_t> slots_;  ///< a hash table of the triangles that were reached; none where free
  Array<std::uint32_t> reached_;
};

}  // namespace oblast::internal::zoning
