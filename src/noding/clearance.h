// Clearance: edges that keep well clear of all others need no second look after rounding.
//
// Let u be the unit in the last place of the largest coordinate of two edges. A cut is the nearest double to a
// crossing, so the pieces of an edge stay within u of it, and in its box. Suppose the round looked at every two edges
// whose boxes meet and that come within t = 32 u of each other, and found of each two one of these:
//   - separate: one has both ends on one side of the other's line, further than t from it. Their pieces
//     stay apart: t is more than twice u.
//   - clear crossing: all four ends are further than t from the other's line. It lies at an angle; let s be
//     the sine. On either edge the next cut, on either side, is at a distance l with l s > t. Pieces of e that begin
//     beyond those cuts stay further than t - 2 u from f; the pieces next to the crossing end in it, and rounding
//     turns them by less than 2 u / l < s / 16 each, too little for one to reach the other.
//   - a common end v, where the edges go out at an angle of sine s. As above, with v for the crossing; where they go
//     out more than a right angle apart, l > t alone is enough (s = 1).
// What is computed to be more than t is at least 25 u: the doubled area over an edge, divided by its length, is rounded
// by less than 7 u where it is computed from an end of the edge. The bounds below leave room for that. Then no two
// pieces of theirs meet but in common ends. Of two edges that keep clear of each other in none of these ways both are
// flagged (near_flag), and an edge whose own cuts are too near each other is. The next round looks at pieces of flagged
// edges only, and at all that those may reach: usually next to nothing.
//
// The search widens each run by 32 units of its own largest coordinate, which together are at least t, so that small
// things are not searched for as if they were large. What it finds is judged by t of all edges together, which is more:
// so some edges are flagged that need not be.
#pragma once

#include <cstdint>
#include <span>

#include "noding/edge_contact.h"
#include "noding/monotone_runs.h"
#include "noding/strands.h"

namespace oblast::internal::noding {

class Clearance {
 public:
  /// For a round that tests every two edges found by runs with run_margins(). Flags edges of `strands`.
  explicit Clearance(Strands& strands);

  /// t of all edges together.
  double distance() const { return distance_; }
  RunMargins run_margins() const { return {distance_, clear_ulps}; }

  /// From several threads at once.
  void flag(std::uint32_t edge) { strands_.add_flag(edge, near_flag); }

  /// Edges from p to u and from p to v: at most the sine, and 0 when they are not clear of each other there.
  float sine_at(const Point& p, const Point& u, const Point& v) const;

  /// Flags the edge when its contacts are too near each other or the edge's neighbours in its strand.
  /// REQUIRES: contacts of one edge, cuts and common ends, sorted along it. Cost: linear.
  void look_along(std::size_t strand, std::span<const EdgeContact> contacts);

 private:
  static constexpr double clear_ulps = 32;

  Strands& strands_;
  double distance_;
};

}  // namespace oblast::internal::noding
