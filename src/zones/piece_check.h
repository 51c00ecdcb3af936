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
// a flood from there. As long as none of them changes, nor one beside them, the answer stays.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/call_memory.h"
#include "zones/diagram.h"
#include "zones/distance.h"

namespace oblast::internal::zoning {

/// The pieces of all edges, in terms of the vertices of a diagram.
struct PieceEnds {
  struct Ends {
    std::uint32_t first, last;
    std::uint32_t object;  ///< of the edge
  };
  LargeArray<Ends> of_piece;
  Array<std::array<std::uint32_t, 2>> at_vertex;  ///< two pieces of the object of the vertex that end there, or none
};

class PieceCheck {
 public:
  PieceCheck(const Diagram& diagram, const PieceEnds& ends, const Room& room)
      : diagram_(diagram), ends_(ends), room_(room), margin_(8 * room.unit) {}

  /// Into how many parts the piece is to be divided: 1 if it is short enough.
  std::uint32_t parts(const PieceEnds::Ends& piece);

  /// Whether the last piece is so near to sites of other objects, or to borders of their cells, that it may pass
  /// through them, once borders are flattened.
  bool is_narrow() const { return narrow_; }

  /// The epsilon that the last piece needs, if it is short enough.
  double error() const { return error_; }

  /// The triangles that were looked at for the last piece.
  std::span<const std::uint32_t> triangles() const { return triangles_; }

 private:
  void begin_flood();
  bool reach(std::uint32_t triangle);
  void grow_slots();
  void flood(std::uint32_t first);
  void look_at(std::uint32_t triangle);
  void look_at_crossing(HalfEdge side);
  void judge(const Point& at, double radius, std::span<const std::uint32_t> sites);
  void relax(const Point& at, double apart, double radius, std::uint32_t site);

  /// The distance from the piece.
  double apart(const Point& p) const {
    const double x = p.x - a_.x, y = p.y - a_.y;
    const double along = x * along_x_ + y * along_y_;
    if (!(along > 0)) return distance(p, a_);
    if (!(along < length_)) return distance(p, b_);
    return std::fabs(x * along_y_ - y * along_x_);
  }

  const Diagram& diagram_;
  const PieceEnds& ends_;
  const Room& room_;
  double margin_;  ///< for the errors of distances

  // Of the piece:
  Point a_, b_;
  double length_ = 0;
  double along_x_ = 0, along_y_ = 0;  ///< its direction, of length 1
  std::uint32_t object_ = 0;
  bool narrow_ = false;
  double error_ = 0;
  double depth_ = 0;  ///< the largest one that was found, by distances from sites
  /// A site that alone would not do, and the largest difference for each of its pieces.
  struct Relaxed {
    std::uint32_t site;
    double difference[3];

    double needed() const { return std::min({difference[0], difference[1], difference[2]}); }
  };
  Array<Relaxed> relaxed_;
  double radius_ = 0;               ///< the largest one of circles that the piece cuts too deep
  Array<HalfEdge> waiting_;         ///< sides of triangles that were reached; what is across may be reached too
  Array<std::uint32_t> triangles_;  ///< that were reached
  Array<std::uint32_t> slots_;      ///< a hash table of these; none where free
  Array<std::uint32_t> taken_;      ///< slots
};

}  // namespace oblast::internal::zoning
